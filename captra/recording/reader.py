"""Reads what a session's file holds, whether its writer closed it or died."""

import base64
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import IO, Any

import orjson
from mcap.exceptions import McapError
from mcap.reader import McapReader, NonSeekingReader, SeekingReader
from mcap.records import Channel, Message, Schema
from mcap.writer import CompressionType, Writer

from captra import archives
from captra.data.recordings import RecordingError
from captra.recording.writer import PAYLOAD_ON, POINT_CLOUD2

MAGIC = b"\x89MCAP0\r\n"
DAMAGE = (McapError, *archives.DAMAGE)
"""What reading a damaged file raises: bits that flipped may stand in lengths, in compressed data, or in JSON."""


def is_mcap(path: Path) -> bool:
    """Whether a file is, or should be, such a recording: one fetched from a service may lack the ending."""
    with path.open("rb") as file:
        return path.suffix == ".mcap" or file.read(len(MAGIC)) == MAGIC


def messages(path: Path) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """Schema name and content of our own messages, in the order of writing, up to where a writer died.

    Raises:
        RecordingError: the file is no recording of a session, is damaged, or ends before its first message.
    """
    with path.open("rb") as file:
        try:
            cloud = b""
            for schema, _, message in records(file):
                name = "" if schema is None else schema.name
                if name == POINT_CLOUD2:
                    cloud = message.data
                elif name.startswith("captra."):
                    body = orjson.loads(message.data)
                    kept = {"payload": base64.b64encode(cloud).decode()} if PAYLOAD_ON in body else {}
                    yield name, body | kept
        except DAMAGE as error:
            raise RecordingError(
                f"{path} is no whole MCAP recording ({str(error) or 'it ends too early'}): record it again"
            ) from error


def records(file: IO[bytes]) -> Iterator[tuple[Schema | None, Channel, Message]]:
    """Everything in a file in the order of writing; one without an index ends where it is cut off.

    Raises:
        McapError: it is cut off before the first message, or damaged; the decoders raise others for that, of `DAMAGE`.
    """
    try:
        reader = SeekingReader(file)
        reader.get_summary()
    except DAMAGE:
        file.seek(0)
        yield from until_cut(NonSeekingReader(file))
    else:
        yield from reader.iter_messages(log_time_order=False)


def until_cut(reader: McapReader) -> Iterator[tuple[Schema | None, Channel, Message]]:
    """Everything that can be read before the end of a file whose writer died.

    Raises:
        McapError: there is nothing; the decoders raise others of `DAMAGE`.
    """
    empty = True
    try:
        for record in reader.iter_messages(log_time_order=False):
            empty = False
            yield record
    except DAMAGE:  # also of a decompressor that has half a chunk
        if empty:
            raise


def salvage(path: Path, whole: Path) -> int:
    """Write what can be read of a file that ends too early or is damaged into a whole one; how many messages.

    Raises:
        RecordingError: nothing can be read of it.
        OSError: the whole one cannot be written.
    """
    channels: dict[int, int] = {}
    count = 0
    with path.open("rb") as source, whole.open("wb") as target:
        writer = Writer(target, compression=CompressionType.LZ4)
        writer.start(profile="", library="captra")
        for schema, channel, message in _readable(source, path.stat().st_size):
            if channel.id not in channels:
                number = 0 if schema is None else writer.register_schema(schema.name, schema.encoding, schema.data)
                channels[channel.id] = writer.register_channel(channel.topic, channel.message_encoding, number)
            writer.add_message(channels[channel.id], message.log_time, message.data, message.publish_time)
            count += 1
        writer.finish()  # type: ignore[no-untyped-call]
    if count == 0:
        raise RecordingError(f"nothing can be read of {path}: delete it")
    return count


def _readable(source: IO[bytes], size_bytes: int) -> Iterator[tuple[Schema | None, Channel, Message]]:
    """Messages up to where the file ends or is damaged; none of its records can be larger than the file."""
    reader = NonSeekingReader(source, validate_crcs=True, record_size_limit=size_bytes)
    with suppress(Exception):  # damaged bytes are met by whatever decodes them: struct, lz4, the memory
        yield from reader.iter_messages(log_time_order=False)
