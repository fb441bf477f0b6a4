"""Populations and matchings on a Dask cluster, with the results of one machine to the last bit.

Needs ``distributed`` (``pip install gearlash[dask]``). Every worker must read the pair file and the files that it names under the same path.
An assembly depends on the seed and its number alone, and a cell of a matching on its two gears: what is lost with a worker, Dask computes again.
"""

import os
from typing import TYPE_CHECKING, Any

from gearlash import _core
from gearlash._population import Matched, Path, Tolerance, warn

if TYPE_CHECKING:
    from distributed import Client


def _gathered(client: "Client", function: Any, items: list[Any], retries: int) -> list[Any]:
    """The results of ``function`` for ``items``, in their order."""
    futures = client.map(function, items, retries=retries, pure=False)
    found: list[Any] = client.gather(futures)  # type: ignore[no-untyped-call]
    return found


def _ranges(total: int, count: int) -> list[tuple[int, int]]:
    """First assembly and number of assemblies of up to ``count`` ranges of almost equal length."""
    ends = [total * k // count for k in range(count + 1)]
    return [(low + 1, high - low) for low, high in zip(ends, ends[1:]) if low < high]


def tolerance(
    client: "Client",
    path: Path,
    *,
    ranges: int = 64,
    assemblies: int | None = None,
    seed: int | None = None,
    threads: int | None = 1,
    retries: int = 3,
) -> Tolerance:
    """As :func:`gearlash.tolerance`, its rows computed in ``ranges`` on the workers of ``client``, each on ``threads`` threads.

    ``retries`` is how often a range that fails is tried again. The contributions come from samples of their own, drawn here on all cores.
    """
    if ranges < 1:
        raise ValueError(f"ranges is {ranges}: a number from 1 on is needed")
    whole = os.path.abspath(path)
    total = _core.tolerance_assemblies(whole) if assemblies is None else assemblies
    found = _gathered(
        client,
        lambda numbers: _core.tolerance_rows(whole, numbers[0], numbers[1], seed, threads),
        _ranges(total, ranges),
        retries,
    )
    text, warned = _core.tolerance_result(whole, assemblies, seed, [rows for rows, _ in found])
    warn(warned)
    return Tolerance(text)


def match(
    client: "Client",
    path: Path,
    wheels: Path,
    pinions: Path,
    *,
    blocks: int = 64,
    target_um: float | None = None,
    threads: int | None = 1,
    retries: int = 3,
) -> Matched:
    """As :func:`gearlash.match`, with ``blocks`` of the wheels on the workers of ``client``. Which gears go together is decided here."""
    if blocks < 1:
        raise ValueError(f"blocks is {blocks}: a number from 1 on is needed")
    files = os.path.abspath(path), os.path.abspath(wheels), os.path.abspath(pinions), target_um
    found = _gathered(
        client,
        lambda k: _core.match_cells(files, (k, blocks), threads),
        list(range(blocks)),
        retries,
    )
    warn(found[0][2])
    return Matched(_core.match_result(files, [(input_hash, cells) for input_hash, cells, _ in found]))
