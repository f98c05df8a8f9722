from pathlib import Path

import pytest
from pydantic import ValidationError
from pydantic_settings import SettingsError

from service.settings import MissingConfigError, Settings, load_settings


@pytest.fixture(autouse=True)
def no_variables(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("CAPTRA_CONFIG", raising=False)


def test_every_default_works() -> None:
    settings = Settings()
    assert (settings.http_host, settings.http_port) == ("127.0.0.1", 8080)
    assert settings.zenoh_listen == ("tcp/127.0.0.1:7447",)
    assert (settings.profile, settings.provider) == ("realtime", "auto")
    assert settings.models_dir == Path(__file__).parents[2] / "models"


def test_variables(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in {
        "HTTP_HOST": "0.0.0.0",
        "HTTP_PORT": "9000",
        "ZENOH_LISTEN": '["tcp/127.0.0.1:1", "tcp/127.0.0.1:2"]',
        "MODELS_DIR": "/models",
        "STATE_DIR": "/state",
        "PROFILE": "paper",
        "PROVIDER": "cpu",
    }.items():
        monkeypatch.setenv(f"CAPTRA_{name}", value)
    settings = Settings()
    assert (settings.http_host, settings.http_port) == ("0.0.0.0", 9000)
    assert settings.zenoh_listen == ("tcp/127.0.0.1:1", "tcp/127.0.0.1:2")
    assert (settings.models_dir, settings.state_dir) == (Path("/models"), Path("/state"))
    assert (settings.profile, settings.provider) == ("paper", "cpu")


def test_arguments_win_over_variables_over_the_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    config = tmp_path / "captra.toml"
    config.write_text('http_port = 1\nmax_sessions = 2\nzenoh_listen = ["tcp/127.0.0.1:3"]\nservice = "cell_4"\n')
    monkeypatch.setenv("CAPTRA_MAX_SESSIONS", "20")
    monkeypatch.setenv("CAPTRA_SERVICE", "cell_5")
    settings = load_settings(config, {"service": "cell_6"})
    assert (settings.http_port, settings.max_sessions, settings.service) == (1, 20, "cell_6")
    assert settings.zenoh_listen == ("tcp/127.0.0.1:3",)
    monkeypatch.setenv("CAPTRA_CONFIG", str(config))
    assert Settings().http_port == load_settings(None, {}).http_port == 1


def test_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(MissingConfigError, match=r"nowhere\.toml"):
        load_settings(tmp_path / "nowhere.toml", {})


def test_unknown_setting_in_the_file_is_refused(tmp_path: Path) -> None:
    config = tmp_path / "captra.toml"
    config.write_text("http_prot = 1\n")
    with pytest.raises(ValidationError, match="http_prot"):
        load_settings(config, {})


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("http_port", 65536),
        ("profile", "fast"),
        ("service", "a/b"),
        ("service", "*"),
        ("service", ""),
        ("zenoh_listen", ()),
        ("max_sessions", 0),
        ("idle_timeout_s", float("nan")),
    ],
)
def test_values_that_make_no_sense_are_refused(name: str, value: object) -> None:
    with pytest.raises(ValidationError, match=name):
        load_settings(None, {name: value})


def test_endpoints_that_are_no_json_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CAPTRA_ZENOH_LISTEN", "tcp/127.0.0.1:7447")
    with pytest.raises(SettingsError, match="zenoh_listen"):
        load_settings(None, {})
