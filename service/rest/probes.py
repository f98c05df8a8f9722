"""Paths for those who run the service: probes and metrics."""

from fastapi import APIRouter, Response
from prometheus_client import CONTENT_TYPE_LATEST

from service.rejections import HinderedError, NotReadyError
from service.rest.catalog_outputs import Health
from service.rest.dependencies import Service
from service.rest.problems import documented

router = APIRouter(tags=["operations"])


@router.head("/v1/health/live", include_in_schema=False)
@router.get("/v1/health/live", responses=documented(guarded=False))
async def live() -> Health:
    """Whether the process answers."""
    return Health(status="live")


@router.head("/v1/health/ready", include_in_schema=False)
@router.get("/v1/health/ready", responses=documented(NotReadyError, HinderedError, guarded=False))
async def ready(service: Service) -> Health:
    """Whether tracking can start at once: kernels compiled, models loaded, not stopping."""
    service.readiness.check()
    return Health(status="ready")


@router.head("/metrics", include_in_schema=False)
@router.get(
    "/metrics",
    response_class=Response,
    responses={200: {"content": {"text/plain": {"schema": {"type": "string"}}}}, **documented()},
)
async def metrics(service: Service) -> Response:
    """Prometheus metrics."""
    return Response(service.telemetry.render(), media_type=CONTENT_TYPE_LATEST)
