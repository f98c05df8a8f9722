import numpy as np
import pytest

from captra.categories import CATEGORIES, Category, UnknownCategoryError, get_category

EVERY = pytest.mark.parametrize("category", CATEGORIES.values(), ids=CATEGORIES.keys())


def test_ten_categories_six_of_them_rigid() -> None:
    assert len(CATEGORIES) == 10
    assert sum(category.background for category in CATEGORIES.values()) == 6
    assert {name for name, category in CATEGORIES.items() if category.symmetric} == {"bottle", "bowl", "can"}


@EVERY
def test_joints_form_a_tree_under_the_root(category: Category) -> None:
    children = [joint.child for joint in category.joints]
    assert sorted([*children, category.root]) == list(range(category.num_parts))
    assert all(joint.parent == category.root for joint in category.joints)
    assert all(np.linalg.norm(joint.axis) == 1 for joint in category.joints)


@EVERY
def test_background_is_one_class_more(category: Category) -> None:
    assert category.num_classes - category.num_parts == (1 if category.background else 0)


@pytest.mark.parametrize(
    ("name", "sigmas"),
    [
        ("mug", (0.02, 5, 0.03)),
        ("glasses", (0.02, 5, 0.02)),
        ("scissors", (0.01, 3, 0.01)),
        ("laptop_articulated", (0.015, 3, 0.02)),
        ("drawers", (0.02, 3, 0.02)),
    ],
)
def test_perturbations_of_the_papers_tables(name: str, sigmas: tuple[float, float, float]) -> None:
    found = get_category(name).perturbation
    assert (found.scale, found.rotation_deg, found.translation_m) == sigmas


def test_unknown_category_names_the_known_ones() -> None:
    with pytest.raises(UnknownCategoryError, match="bottle, bowl"):
        get_category("teapot")
