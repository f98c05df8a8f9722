"""Answers about the service itself: categories, models, probes."""

from typing import Any, Literal

from pydantic import BaseModel, Field

from service.rest.vectors import Vector3


class JointInfo(BaseModel):
    """One degree of freedom."""

    name: str
    kind: Literal["revolute", "prismatic"]
    child: str = Field(description="Part that moves.")
    parent: str = Field(description="Part that it moves against.")
    axis: Vector3 = Field(description="In the object's axes at rest.")


class CategoryInfo(BaseModel):
    """What is known of objects of one kind."""

    name: str
    parts: list[str] = Field(description="The order of every per-part list.")
    root: str = Field(description="The part that all others move against.")
    joints: list[JointInfo]
    symmetric: bool = Field(description="Whether the rotation about the object's y axis carries no information.")
    surroundings: bool = Field(
        description="Whether clouds may hold the scene around the object; if not, the object alone."
    )
    trackable: bool = Field(description="Whether this service holds a model of it.")


class Categories(BaseModel):
    """All categories."""

    categories: list[CategoryInfo]


class ModelInfo(BaseModel):
    """A model that this service holds."""

    category: str
    precision: str = Field(description="Of the weights as stored.")
    provider: str = Field(description="What runs the networks.")
    profiles: list[str] = Field(description="Sampling budgets that sessions may ask for.")
    loaded: list[str] = Field(description="Profiles whose networks are in memory.")
    error: str | None = Field(description="Why it cannot be used, if so.")
    manifest: dict[str, Any] = Field(description="Shapes, hashes, training and scores, as the bundle states them.")


class Models(BaseModel):
    """All models."""

    models: list[ModelInfo]


class Health(BaseModel):
    """Answer of a probe."""

    status: Literal["live", "ready"]
