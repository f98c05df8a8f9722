import pytest

from captra.data.credits import Credit, UnnamedAuthorError


@pytest.mark.parametrize(
    ("entry", "credit"),
    [
        ({"licence": "CC BY 4.0", "author": "A. Nother", "notes": ""}, Credit("CC BY 4.0", "A. Nother")),
        ({"licence": "CC-BY 3.0", "notes": "size w,d,h=5,5,20; author Jay-Artist"}, Credit("CC-BY 3.0", "Jay-Artist")),
        ({"licence": "CC-BY 3.0", "notes": "author A. Nother; lid overhangs"}, Credit("CC-BY 3.0", "A. Nother")),
        ({"licence": "CC-BY 3.0 US (A. Nother)", "notes": ""}, Credit("CC-BY 3.0 US", "A. Nother")),
        ({"licence": "CC BY 4.0 (see repo)", "author": "A. Nother"}, Credit("CC BY 4.0", "A. Nother")),
        ({"licence": "CC0", "notes": "as its author drew it"}, Credit("CC0", "")),
    ],
)
def test_the_author_is_taken_from_where_the_library_has_it(entry: dict[str, str], credit: Credit) -> None:
    assert Credit.of(entry) == credit


@pytest.mark.parametrize("credit", [Credit("CC0", ""), Credit("CC BY 4.0", "A. Nother"), Credit("MIT", "N (Ltd)")])
def test_what_is_kept_beside_views_is_read_again(credit: Credit) -> None:
    assert Credit.read(str(credit)) == credit


@pytest.mark.parametrize("licence", ["CC BY 4.0", "CC-BY 3.0 US", "cc-by-4.0"])
def test_who_has_to_be_named_has_to_be_known(licence: str) -> None:
    with pytest.raises(UnnamedAuthorError, match=r'mug/cup .* add "author"'):
        Credit(licence, "").checked("mug/cup")
    assert Credit(licence, "A. Nother").checked("mug/cup").author == "A. Nother"
    assert Credit("CC0", "").checked("mug/cup").author == ""
