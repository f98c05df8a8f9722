import pytest

from captra.categories import CATEGORIES
from captra.evaluation import paper


def test_every_part_of_every_category_has_its_figures() -> None:
    assert set(paper.CATEGORY_FIGURES) == set(CATEGORIES)
    for name, figures in paper.CATEGORY_FIGURES.items():
        category = CATEGORIES[name]
        moved = {joint.child: joint.kind for joint in category.joints}
        for rows in (figures.ours, figures.oracle_icp):
            assert len(rows) == category.num_parts
            for part, row in enumerate(rows):
                assert (row.joint_deg is not None) == (moved.get(part) == "revolute")
                assert (row.joint_cm is not None) == (moved.get(part) == "prismatic")


@pytest.mark.parametrize(("rigid", "expected"), [(True, paper.RIGID_MEAN), (False, paper.ARTICULATED_MEAN)])
def test_averaged_as_the_paper_does_they_give_its_means(rigid: bool, expected: paper.Figures) -> None:
    """Over the parts of a category first, then over categories; what parts are rounded to leaves 0.05."""
    chosen = [
        paper.CATEGORY_FIGURES[name].ours for name, category in CATEGORIES.items() if category.background == rigid
    ]
    mean = paper.mean_figures([paper.mean_figures(rows) for rows in chosen])
    assert mean.within_5deg_5cm_percent == pytest.approx(expected.within_5deg_5cm_percent, abs=0.05)
    assert mean.iou_percent == pytest.approx(expected.iou_percent, abs=0.05)
    assert mean.rotation_deg == pytest.approx(expected.rotation_deg, abs=0.01)
    assert mean.translation_cm == pytest.approx(expected.translation_cm, abs=0.01)
    if not rigid:
        assert mean.joint_deg == pytest.approx(expected.joint_deg, abs=0.01)
        assert mean.joint_cm == pytest.approx(expected.joint_cm, abs=0.01)
