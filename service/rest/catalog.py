"""Paths that tell what can be tracked."""

from fastapi import APIRouter

from captra.categories import CATEGORIES, Category
from service.rest.catalog_outputs import Categories, CategoryInfo, JointInfo, ModelInfo, Models
from service.rest.dependencies import Service
from service.rest.problems import documented

router = APIRouter(prefix="/v1", tags=["catalog"])


@router.get("/categories", responses=documented())
async def list_categories(service: Service) -> Categories:
    """Every category, its parts and joints, and whether it can be tracked here."""
    trackable = {model.category for model in service.provider.models() if model.error is None}
    return Categories(categories=[info_of(category, trackable) for category in CATEGORIES.values()])


@router.get("/models", responses=documented())
async def list_models(service: Service) -> Models:
    """Every model here: precision, provider, profiles, and the bundle's own manifest."""
    fields = ModelInfo.model_fields
    models = service.provider.models()
    return Models(
        models=[ModelInfo.model_validate({name: getattr(model, name) for name in fields}) for model in models]
    )


def info_of(category: Category, trackable: set[str]) -> CategoryInfo:
    """A category as the REST API shows it."""
    joints = [
        JointInfo(
            name=joint.name,
            kind=joint.kind,
            child=category.parts[joint.child],
            parent=category.parts[joint.parent],
            axis=list(joint.axis),
        )
        for joint in category.joints
    ]
    return CategoryInfo(
        name=category.name,
        parts=list(category.parts),
        root=category.parts[category.root],
        joints=joints,
        symmetric=category.symmetric,
        surroundings=category.background,
        trackable=category.name in trackable,
    )
