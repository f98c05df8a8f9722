"""Where the service is reached by Zenoh, for those who listen before there is a session."""

from fastapi import APIRouter, Request
from pydantic import BaseModel, ConfigDict, Field

from service.keys import ServiceKeys
from service.rest.dependencies import Service
from service.rest.problems import documented
from service.rest.views import endpoints_for

router = APIRouter(prefix="/v1/zenoh", tags=["sessions"])


class Network(BaseModel):
    """The deployment on Zenoh."""

    model_config = ConfigDict(
        json_schema_extra={
            "examples": [
                {
                    "endpoints": ["tcp/127.0.0.1:7447"],
                    "sessions": "captra/default/sessions",
                    "previews": "captra/default/previews",
                }
            ]
        }
    )

    endpoints: list[str] = Field(description="Connect to one of these.")
    sessions: str = Field(description="Keys of a session are below this one and its id.")
    previews: str = Field(description="Clouds that no session tracks are put below this one and a name.")


@router.get("", responses=documented())
async def get_network(request: Request, service: Service) -> Network:
    """Endpoints and keys of this deployment."""
    keys = ServiceKeys(service.settings.service)
    endpoints = endpoints_for(service, request.url.hostname or "")
    return Network(endpoints=endpoints, sessions=keys.sessions, previews=keys.previews)
