"""Populations on a Dask cluster: parts go to its workers, and their sum is what one machine would have found, to the last bit.

Needs ``distributed`` (``pip install gearlash[dask]``). The pair file and what it names must be readable by every worker under the same path.
A part that is lost with its worker is run again by Dask; parts do not depend on where or when they run.
"""

import os
from collections.abc import Callable
from typing import TYPE_CHECKING

from gearlash import _core
from gearlash._population import Matched, Path, Tolerance, warn

if TYPE_CHECKING:
    from distributed import Client

Part = tuple[str, list[str]]
"""The text of a part's file, and the warnings of what it was read from."""


def _part(
    path: str, assemblies: int | None, seed: int | None, shard: tuple[int, int], threads: int | None
) -> Part:
    return _core.tolerance_part(path, assemblies, seed, shard, threads)


def _match_part(
    path: str,
    folders: tuple[str, str],
    target_um: float | None,
    shard: tuple[int, int],
    threads: int | None,
) -> Part:
    return _core.match_part(path, *folders, target_um, shard, threads)


def _all(
    client: "Client", part: Callable[[tuple[int, int]], Part], shards: int, retries: int
) -> tuple[list[str], list[str]]:
    """The texts of all parts, and the warnings, which are the same of each."""
    each = client.map(
        lambda shard: part((shard, shards)), range(1, shards + 1), retries=retries, pure=False
    )
    parts: list[Part] = client.gather(each)  # type: ignore[no-untyped-call]
    return [text for text, _ in parts], parts[0][1] if parts else []


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
    texts, warned = _all(
        client, lambda shard: _part(whole, assemblies, seed, shard, threads), shards, retries
    )
    warn(warned)
    return Tolerance(_core.tolerance_result(texts))


def match(
    client: "Client",
    path: Path,
    wheels: Path,
    pinions: Path,
    *,
    shards: int = 64,
    target_um: float | None = None,
    threads: int | None = 1,
    retries: int = 3,
) -> Matched:
    """As :func:`gearlash.match`, every wheel with every pinion in ``shards`` parts on the workers of ``client``, as :func:`tolerance` does it.

    Which go together is then decided here, by all parts.
    """
    whole = os.path.abspath(path)
    folders = os.path.abspath(wheels), os.path.abspath(pinions)
    texts, warned = _all(
        client,
        lambda shard: _match_part(whole, folders, target_um, shard, threads),
        shards,
        retries,
    )
    warn(warned)
    return Matched(_core.match_result(texts))
