"""The FastAPI application of one service."""

from typing import Any

from fastapi import FastAPI

import captra
from service.rest import catalog, documentation, frames, network, probes, problems, recordings, sessions
from service.rest.dependencies import Workers
from service.rest.guard import Guard
from service.security.wiring import gate_of
from service.tracking_service import TrackingService
from service.viewer import pages, socket
from service.viewer.previews import Previews

DESCRIPTION = """
Where is this object now? Open a session with the first pose of an object of a known category, stream point clouds
(by Zenoh, or one by one by HTTP), and get the pose of every part, joint states and the health of the track for each.

Metres, seconds, radians; quaternions in the order x, y, z, w; poses in the frame of the clouds.
"""


class CaptraApi(FastAPI):
    """An application whose document describes problems as problem+json."""

    def openapi(self) -> dict[str, Any]:
        """The OpenAPI document."""
        if self.openapi_schema is None:
            document = super().openapi()
            schemas = document.setdefault("components", {}).setdefault("schemas", {})
            problem = problems.Problem.model_json_schema(ref_template="#/components/schemas/{model}")
            schemas |= problem.pop("$defs", {})
            schemas["Problem"] = problem
            bearer = {"type": "http", "scheme": "bearer", "description": "API key or signed token, where asked for."}
            document["components"]["securitySchemes"] = {"bearer": bearer}
            document["security"] = [{}, {"bearer": []}]
        return super().openapi()


def create_app(service: TrackingService) -> FastAPI:
    """The REST API of a service; starting and stopping the service is up to the caller."""
    app = CaptraApi(title="captra", version=captra.__version__, description=DESCRIPTION, docs_url=None, redoc_url=None)
    app.state.service = service
    app.state.workers = Workers()
    app.state.previews = Previews(service)
    problems.install(app)
    documentation.install(app)
    app.add_middleware(Guard, gate=gate_of(service.settings))
    for module in (sessions, frames, recordings, network, catalog, probes):
        app.include_router(module.router)
    app.include_router(socket.router)
    pages.install(app, service.settings.recordings_dir, service.recordings)
    return app
