"""A frame and its mask in one HTTP body."""

from collections.abc import AsyncIterator
from dataclasses import dataclass

from pydantic.config import JsonDict
from starlette.datastructures import FormData, Headers, UploadFile
from starlette.formparsers import MultiPartException, MultiPartParser

from service.codecs.masks import BOX
from service.rejections import InvalidRequestError, Mistake

MULTIPART = "multipart/form-data"
FILES = {"cloud", "mask"}
WITH_MASK: JsonDict = {
    "type": "object",
    "required": ["cloud"],
    "properties": {name: {"type": "string", "format": "binary"} for name in sorted(FILES)},
}
"""Schema of a form: the frame with its encoding as content type, and an 8-bit grey PNG."""

LARGEST_COLUMN = 2**16 - 1


@dataclass(frozen=True)
class SentFrame:
    """What a request holds."""

    encoding: str
    """Of the cloud or image."""
    payload: bytes
    """The cloud or image."""
    mask: bytes
    """A mask image, a packed box, or nothing."""


async def frame_of(body: bytes, content_type: str, box: str | None) -> SentFrame:
    """The frame in a body, and its mask or box.

    Raises:
        InvalidRequestError: the form cannot be read, lacks the cloud or holds something else, or the box lies beyond
            any image.
    """
    mask = b"" if box is None else packed_box(box)
    if content_type.partition(";")[0].strip().lower() != MULTIPART:
        return SentFrame(content_type, body, mask)

    async def chunks() -> AsyncIterator[bytes]:
        yield body
        yield b""

    parser = MultiPartParser(Headers({"content-type": content_type}), chunks())  # type: ignore[arg-type]
    try:
        form = await parsed(parser)
        files = {name: file for name, file in form.multi_items() if isinstance(file, UploadFile)}
        if "cloud" not in files:
            raise InvalidRequestError(
                Mistake("/body/cloud", "the form lacks the file 'cloud', with its encoding as content type")
            )
        if unknown := sorted({name for name, _ in form.multi_items()} - set(files)) + sorted(set(files) - FILES):
            raise InvalidRequestError(
                *(
                    Mistake(f"/body/{name}", "the form holds the files 'cloud' and 'mask', each with a file name")
                    for name in unknown
                )
            )
        payload = await files["cloud"].read()
        return SentFrame(
            files["cloud"].content_type or "", payload, await files["mask"].read() if "mask" in files else mask
        )
    finally:
        for file in parser._files_to_close_on_error:  # all there are; by itself it forgets them after some errors
            file.close()


async def parsed(parser: MultiPartParser) -> FormData:
    """The form.

    Raises:
        InvalidRequestError: it cannot be read.
    """
    try:
        return await parser.parse()
    except (MultiPartException, KeyError, ValueError) as error:
        raise InvalidRequestError(Mistake("/body", f"the form cannot be read: {error}")) from error


def packed_box(text: str) -> bytes:
    """A box as it travels in attachments.

    Raises:
        InvalidRequestError: an edge is beyond any image.
    """
    edges = [int(edge) for edge in text.split(",")]
    if max(edges) > LARGEST_COLUMN:
        raise InvalidRequestError(Mistake("/query/box", f"no edge is beyond {LARGEST_COLUMN}"))
    return BOX.pack(*edges)
