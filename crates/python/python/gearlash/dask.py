"""Populations on a Dask cluster: parts go to its workers, and their sum is what one machine would have found, to the last bit.

Needs ``distributed`` (``pip install gearlash[dask]``). The pair file and what it names must be readable by every worker under the same path.
A part that is lost with its worker is run again by Dask; parts do not depend on where or when they run.
"""

import json
import os
from typing import TYPE_CHECKING

from gearlash import _core
from gearlash._population import Matched, Path, Tolerance
from gearlash._population import match as match_here

if TYPE_CHECKING:
    from distributed import Client


def _part(
    path: str, assemblies: int | None, seed: int | None, shard: tuple[int, int], threads: int | None
) -> str:
    return _core.tolerance_part(path, assemblies, seed, shard, threads)


def _match(
    path: str, wheels: str, pinions: str, target_um: float | None, threads: int | None
) -> Matched:
    return match_here(path, wheels, pinions, target_um=target_um, threads=threads)


def tolerance(
    client: "Client",
    path: Path,
    *,
    shards: int = 64,
    assemblies: int | None = None,
    seed: int | None = None,
    threads: int | None = 1,
    retries: int = 3,
) -> Tolerance:
    """As :func:`gearlash.tolerance`, in ``shards`` parts on the workers of ``client``, each on ``threads`` threads.

    ``retries`` is how often a part that fails is tried again; one whose worker dies is tried again by Dask as often as it allows.
    """
    whole = os.path.abspath(path)
    parts = client.map(
        lambda shard: _part(whole, assemblies, seed, (shard, shards), threads),
        range(1, shards + 1),
        retries=retries,
        pure=False,
    )
    texts: list[str] = client.gather(parts)  # type: ignore[no-untyped-call]
    return Tolerance(json.loads(_core.tolerance_result(texts)))


def match(
    client: "Client",
    path: Path,
    wheels: Path,
    pinions: Path,
    *,
    target_um: float | None = None,
    threads: int | None = None,
) -> Matched:
    """As :func:`gearlash.match`, on a worker of ``client``: the assignment looks at every gear at once, so that it is not cut."""
    folders = [os.path.abspath(folder) for folder in (wheels, pinions)]
    future = client.submit(
        _match, os.path.abspath(path), *folders, target_um, threads, retries=3, pure=False
    )
    found: Matched = future.result()
    return found
