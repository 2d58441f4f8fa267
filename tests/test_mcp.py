"""Tools for assistants: offered where datasette-mcp is installed, with the answers of the other doors."""

import json
import urllib.request

import pytest

from esicatalog.web.mcp_tools import _MOST_SHOWN

pytest.importorskip("datasette_mcp", reason="datasette-mcp is not installed")

HEADERS = {"accept": "application/json, text/event-stream", "content-type": "application/json"}


def posted(served: str, session: dict[str, str], body: dict):
    request = urllib.request.Request(f"{served}/-/mcp", json.dumps(body).encode(), {**HEADERS, **session})
    with urllib.request.urlopen(request) as response:
        return response.headers, response.read().decode()


def asked(served: str, method: str, parameters: dict):
    """One request in a session of its own."""
    client = {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}}
    headers, _ = posted(served, {}, {"jsonrpc": "2.0", "id": 0, "method": "initialize", "params": client})
    session = {"mcp-session-id": headers["mcp-session-id"]} if headers["mcp-session-id"] else {}
    posted(served, session, {"jsonrpc": "2.0", "method": "notifications/initialized"})
    _, text = posted(served, session, {"jsonrpc": "2.0", "id": 1, "method": method, "params": parameters})
    lines = [line.removeprefix("data: ") for line in text.splitlines() if line.startswith("data: ")] or [text]
    return json.loads(lines[-1])["result"]


def called(served: str, tool: str, **arguments):
    result = asked(served, "tools/call", {"name": tool, "arguments": arguments})
    return result.get("isError", False), result["content"][0]["text"]


def test_the_tools_are_offered(served):
    names = {tool["name"] for tool in (asked(served, "tools/list", {}))["tools"]}
    assert {"identify_device", "find_devices", "device_sheet"} <= names


def test_their_answers(served):
    failed, text = called(served, "identify_device", vendor="0x1097", product="#x2406", revision="143")
    assert (failed, json.loads(text)["match"]) == (False, "exact")
    failed, text = called(served, "find_devices", filters={"mode": "CSV", "vendor": "0x1097"})
    assert [device["type"] for device in json.loads(text)["devices"]] == ["EYOU_ServoModule_V143"]
    failed, text = called(served, "device_sheet", identity="0x1097:0x2406")
    assert json.loads(text)["identity"]["revision_no"] == 0x8F


def test_filters_are_those_of_the_command(served):
    """Numbers, truth values and several objects too; data/ has three drives that run CSV and map both objects."""
    filters = {"mode": "CSV", "maps": ["0x6040"], "bits": 16, "include-hidden": True, "strict": False, "limit": 2}
    failed, text = called(served, "find_devices", filters=filters)
    assert not failed, text
    found = json.loads(text)
    assert (found["count"], found["shown"], len(found["devices"])) == (3, 2, 2)
    failed, text = called(served, "find_devices", filters={"maps": ["0x6040", "0x60FF"], "not-maps": ["0x1", "0x2"]})
    assert (failed, json.loads(text)["count"]) == (False, 3)


def test_no_more_than_are_said_are_shown(served):
    tools = asked(served, "tools/list", {})["tools"]
    (words,) = [tool["description"] for tool in tools if tool["name"] == "find_devices"]
    assert f"At most {_MOST_SHOWN} devices" in words


def test_a_sheet_names_variants_and_what_fits_into_slots(served):
    """EYOU has module 0x119800 in slot 0 by default: 0x219800 of the same file exchanges something else."""
    sheets = []
    for modules in ([], ["0=0x219800"]):
        failed, text = called(served, "device_sheet", identity="0x1097:0x2406", modules=modules)
        assert not failed, text
        sheets.append(json.loads(text))
    assert [len(sheet["variants"]) for sheet in sheets] == [1, 1]
    plugged = [
        [module["choice"] for slot in sheet["slots"] for module in slot["modules"] if module["plugged"]]
        for sheet in sheets
    ]
    assert plugged == [["0x119800"], ["0x219800"]]
    assert sheets[0]["process_image"] != sheets[1]["process_image"]
    failed, text = called(served, "device_sheet", identity="0x1097:0x2406", modules=["0=0x1"])
    assert failed
    assert "does not fit slot 0" in text


def test_what_is_wrong_is_told_in_words(served):
    failed, text = called(served, "find_devices", filters={"mode": "XYZ"})
    assert failed
    assert "say one of PP" in text
    failed, text = called(served, "find_devices", filters={"bits": "8"})
    assert failed
    assert "give maps" in text
    failed, text = called(served, "device_sheet", identity="0x1:0x2")
    assert failed
    assert "is not in the catalog" in text
