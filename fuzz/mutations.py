"""Changes to files, as damage, carelessness or malice would make them; all chance comes from a ``random.Random``."""

from random import Random

from lxml import etree

VALUES = [
    *("", "0", "1", "-1", "7", "255", "#x0", "#x1600", "#x1A00", "#x6502", "#xFFFF", "#xFFFFFFFF"),
    *("#x7FFFFFFFFFFFFFFF", "4294967296", "-9223372036854775807", "-9223372036854775808", "99999999999999999999"),
    *("0x10", "#x0x10", "x", "true", "0001", "FFFFFFFF", "00ff1", "1e308", "1e999", "nan", "G", "\u0663", "9" * 5000),
    *("STRING(3)", "STRING(999999999999)", "ARRAY [0..7] OF BYTE", "ARRAY [0..999999999] OF BYTE", "ARRAY [7..0] OF X"),
    *("DT1018", "UDINT", "U", "Outputs", "MBoxIn", "SubIndex 001", "\N{SNOWMAN}", "\U0001f600", "a\u0301", "\u202e"),
]
"""Texts that something in a document takes seriously, and some at the edges of what numbers may be."""


def mutated_tree(root: etree._Element, chance: Random) -> bytes:
    """The document with a few values, attributes and elements changed, moved, doubled or removed."""
    for _ in range(chance.randint(1, 8)):
        elements = [element for element in root.iter() if element is not root]
        if not elements:
            break
        element = chance.choice(elements)
        parent = element.getparent()
        match chance.choice(["text", "attribute", "tail", "remove", "double", "move", "swap"]):
            case "text":
                element.text = chance.choice(VALUES)
            case "attribute" if element.attrib:
                element.set(chance.choice(sorted(element.attrib)), chance.choice(VALUES))
            case "tail":
                element.tail = chance.choice(VALUES)
            case "remove":
                parent.remove(element)
            case "double":
                parent.insert(
                    chance.randint(0, len(parent)), etree.fromstring(etree.tostring(element, with_tail=False))
                )
            case "move":
                target = chance.choice(elements)
                if target not in element.iter():
                    target.append(element)
            case "swap":
                parent.insert(chance.randint(0, len(parent) - 1), element)
            case _:
                pass
    return etree.tostring(root)


def mutated_bytes(content: bytes, chance: Random) -> bytes:
    """The bytes with a few flipped, and spans deleted, doubled, swapped, filled or cut off."""
    data = bytearray(content)
    for _ in range(chance.randint(1, 6)):
        if not data:
            break
        start = chance.randrange(len(data))
        end = min(len(data), start + chance.choice((1, 2, 4, 16, 256, 4096)))
        match chance.choice(["flip", "byte", "delete", "double", "swap", "fill", "cut"]):
            case "flip":
                data[start] ^= 1 << chance.randrange(8)
            case "byte":
                data[start] = chance.choice((0, 0x7F, 0x80, 0xFE, 0xFF, ord("<"), ord("&"), ord('"')))
            case "delete":
                del data[start:end]
            case "double":
                data[start:start] = data[start:end]
            case "swap":
                other = chance.randrange(len(data))
                data[start], data[other] = data[other], data[start]
            case "fill":
                data[start:end] = bytes([chance.choice((0x00, 0xFF))]) * (end - start)
            case "cut":
                del data[start:]
            case _:
                pass
    return bytes(data)


def mutated_lines(content: bytes, chance: Random) -> bytes:
    """The text with lines dropped, doubled, moved or cut, and words exchanged for others."""
    lines = content.decode("utf-8", "replace").split("\n")
    for _ in range(chance.randint(1, 8)):
        if not lines:
            break
        at = chance.randrange(len(lines))
        match chance.choice(["drop", "double", "move", "cut", "word", "indent"]):
            case "drop":
                del lines[at]
            case "double":
                lines.insert(at, lines[at])
            case "move":
                lines.insert(chance.randrange(len(lines)), lines.pop(at))
            case "cut":
                lines[at] = lines[at][: chance.randint(0, len(lines[at]))]
            case "word" if words := lines[at].split(" "):
                words[chance.randrange(len(words))] = chance.choice(VALUES)
                lines[at] = " ".join(words)
            case "indent":
                lines[at] = chance.choice(("", " ", "  ", "\t")) + lines[at].strip()
            case _:
                pass
    return "\n".join(lines).encode("utf-8", "surrogatepass")
