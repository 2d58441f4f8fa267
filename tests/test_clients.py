"""Many clients at once: no request is lost, and the same question gets the same answer from all."""

import asyncio
import random
import time
from collections import Counter
from typing import Any

import httpx
import pytest
from library import SEED

CLIENTS = 100
Answers = dict[int, set[Any]]
"""Status and content of all answers by question."""
SCAN = "vendor,product,revision\n0x1097,0x2406,0x8f\n0xe5c,0x0d080808,0x00110000\n1,2,3\n"
QUESTIONS: list[tuple[str, str, dict[str, Any]]] = [
    ("GET", "/-/esi/identify.json?vendor=0x1097&product=0x2406&revision=0x8f", {}),
    ("GET", "/-/esi/identify.json?vendor=1&product=1", {}),
    ("POST", "/-/esi/identify.json", {"content": SCAN.encode()}),
    ("GET", "/-/esi/devices.json?mode=csv", {}),
    ("GET", "/-/esi/devices.json?maps=0x60ff&text=L6N", {}),
    ("GET", "/-/esi/?sync=sync1", {}),
    ("GET", "/-/esi/device/0x1097/0x2406/0x8f", {}),
    ("GET", "/-/esi/device/0xe5c/0xa202/latest.json", {}),
    ("GET", "/-/esi/device/0x1097/0x2406/0x8f/objects", {}),
    ("GET", "/-/esi/device/0x1097/0x2406/0x8f/export/igh", {}),
    ("GET", "/-/esi/device/0xe5c/0xd080808/0x110000/export/sii", {}),
    ("GET", "/-/esi/device/zz/1/1.json", {}),
    ("GET", "/catalog/devices.json?_shape=array", {}),
    ("GET", "/catalog/who_maps_an_object.json?index=0x60FF&subindex=&_shape=array", {}),
    ("GET", "/catalog.json?sql=select+count(*)+from+pdo_entries&_shape=array", {}),
]


async def one_client(number: int, web: httpx.AsyncClient, until: float, answers: Answers, counts: Counter[str]) -> None:
    chosen = random.Random(f"{SEED} {number}")
    while time.monotonic() < until:
        at = chosen.randrange(len(QUESTIONS))
        method, path, options = QUESTIONS[at]
        counts["asked"] += 1
        response = await web.request(method, path, **options)
        counts["answered"] += 1
        answers.setdefault(at, set()).add((response.status_code, response.content))


async def many_clients(address: str, seconds: float) -> None:
    """Let clients ask for a while; lost requests raise. Every question has one answer only."""
    answers: Answers = {}
    counts: Counter[str] = Counter()
    connections = httpx.Limits(max_connections=CLIENTS, max_keepalive_connections=CLIENTS)
    async with httpx.AsyncClient(base_url=address, timeout=120, limits=connections, follow_redirects=True) as web:
        until = time.monotonic() + seconds
        await asyncio.gather(*(one_client(number, web, until, answers, counts) for number in range(CLIENTS)))
    assert counts["asked"] == counts["answered"] >= CLIENTS
    for at, found in answers.items():
        statuses = {status for status, _ in found}
        assert len(found) == 1, (QUESTIONS[at], statuses)
        assert statuses <= {200, 400, 404}, QUESTIONS[at]
    print(f"{CLIENTS} clients, {seconds:.0f} s: {counts['answered']} requests, none lost")


async def test_a_hundred_clients_for_some_seconds(served):
    await many_clients(served, 0.5)


@pytest.mark.faults
async def test_a_hundred_clients_for_a_minute(served):
    await many_clients(served, 60)
