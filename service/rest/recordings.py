"""Paths of recordings: which there are, fetching one, deleting one."""

from typing import Annotated

from fastapi import APIRouter, Path
from fastapi.responses import FileResponse
from pydantic import BaseModel, ConfigDict, Field

from service.rejections import InvalidRequestError, UnfinishedRecordingError, UnknownRecordingError
from service.rest.dependencies import OnThread, Service
from service.rest.examples import RECORDING
from service.rest.problems import documented

router = APIRouter(prefix="/v1/recordings", tags=["recordings"])

MCAP = "application/vnd.mcap"
PROBLEMS = (UnknownRecordingError, UnfinishedRecordingError, InvalidRequestError)

Name = Annotated[str, Path(description="As `GET /v1/recordings` lists it.", max_length=120)]


class Recording(BaseModel):
    """A recorded session."""

    model_config = ConfigDict(json_schema_extra={"examples": [RECORDING]})

    name: str = Field(description="Category and session id; further files of a session that went on are numbered.")
    size_bytes: int = Field(description="Of the file.")
    finished: bool = Field(description="Whether it is whole and can be fetched: it is written no more.")


class Recordings(BaseModel):
    """All recordings, by name."""

    recordings: list[Recording]


@router.get("", responses=documented())
async def list_recordings(service: Service, threads: OnThread) -> Recordings:
    """Every recording of sessions that were opened with `record`."""
    found = await threads.run(service.recordings.all)
    return Recordings(
        recordings=[Recording(name=each.name, size_bytes=each.size_bytes, finished=each.finished) for each in found]
    )


@router.get(
    "/{name}",
    response_class=FileResponse,
    responses={
        200: {"content": {MCAP: {"schema": {"type": "string", "format": "binary"}}}},
        **documented(*PROBLEMS),
    },
)
async def get_recording(name: Name, service: Service, threads: OnThread) -> FileResponse:
    """The MCAP file, which Foxglove and Rerun open and `captra track` replays."""
    path = await threads.run(lambda: service.recordings.path(name))
    return FileResponse(path, media_type=MCAP, filename=path.name)


@router.delete("/{name}", status_code=204, responses=documented(*PROBLEMS))
async def delete_recording(name: Name, service: Service, threads: OnThread) -> None:
    """Delete the file."""
    await threads.run(lambda: service.recordings.remove(name))
