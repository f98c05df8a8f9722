"""What closes a bottle: solids that stand on its mouth, turned about y except for a pump's nozzle."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from captra.data.shapes.curves import rounded_polyline
from captra.data.shapes.draws import between, chance
from captra.data.shapes.mesh import Mesh, merged
from captra.data.shapes.surfaces import SEGMENTS, revolve, rounded_box


@dataclass(frozen=True)
class Opening:
    """What a cap has to fit."""

    mouth: float
    """Outer radius of the mouth, metres."""
    body: float
    """Largest radius of the bottle."""
    height: float
    """Of the bottle without its cap."""


CapMaker = Callable[[np.random.Generator, Opening], Mesh]
"""Makes a mesh whose y = 0 is the mouth."""


def _solid(points: list[tuple[float, float]], fillet: float = 0.001, knurls: int = 0) -> Mesh:
    outline = rounded_polyline(np.array([(0.0, points[0][1]), *points, (0.0, points[-1][1])]), fillet, 4)
    factor = None
    if knurls:
        angle = np.arange(SEGMENTS) * (2 * np.pi / SEGMENTS)
        factor = 1 + 0.02 * np.cos(knurls * angle)
    return revolve(outline, factor)


def screw(rng: np.random.Generator, at: Opening) -> Mesh:
    """Screw cap over the neck, with a collar ring below it now and then."""
    radius, tall = at.mouth + between(rng, 0.001, 0.003), between(rng, 0.009, 0.024)
    low = -tall * between(rng, 0.5, 0.95)
    cap = _solid([(radius, low), (radius * between(rng, 0.92, 1), low + tall)], 0.0015, int(rng.choice([0, 0, 10, 14])))
    if not chance(rng, 0.5):
        return cap
    ring = between(rng, 0.001, 0.004)
    return merged([cap, _solid([(radius + ring, low - 0.004), (radius + ring, low - 0.001)], 0.0005)])


def wide(rng: np.random.Generator, at: Opening) -> Mesh:
    """Lid or flip-top about as wide as the body."""
    radius = at.mouth + (max(at.body - at.mouth, 0.0) * between(rng, 0.0, 1.03) if chance(rng, 0.7) else 0.002)
    tall = np.clip(at.height * between(rng, 0.05, 0.25), 0.008, 0.06)
    return _solid([(radius, -0.004), (radius * between(rng, 0.8, 1.02), tall)], between(rng, 0.0005, 0.005))


def crown(rng: np.random.Generator, at: Opening) -> Mesh:
    """Crown cork."""
    return _solid([(at.mouth + 0.0025, -0.004), (at.mouth + 0.0005, 0.0022)], 0.001, int(rng.choice([0, 10])))


def foil(rng: np.random.Generator, at: Opening) -> Mesh:
    """Capsule of a wine bottle, flush with the neck."""
    return _solid([(at.mouth + 0.0006, -between(rng, 0.02, 0.05)), (at.mouth + 0.0006, 0.001)], 0.001)


def cork(rng: np.random.Generator, at: Opening) -> Mesh:
    """Cork or stopper that sticks out."""
    radius = at.mouth * between(rng, 0.7, 1.35)
    tall = between(rng, 0.004, 0.025)
    return _solid(
        [(at.mouth * 0.75, -0.002), (at.mouth * 0.75, 0.002), (radius, 0.003), (radius, tall)],
        between(rng, 0.0005, 0.006),
    )


def sport(rng: np.random.Generator, at: Opening) -> Mesh:
    """Lid with a drinking spout."""
    base = at.mouth + (max(at.body - at.mouth, 0) * between(rng, 0, 0.9) if chance(rng, 0.5) else 0.002)
    tall, spout, up = between(rng, 0.008, 0.025), base * between(rng, 0.25, 0.6), between(rng, 0.008, 0.03)
    points = [
        (base, -0.008),
        (base * between(rng, 0.75, 1), tall),
        (spout, tall + between(rng, 0, 0.008)),
        (spout, tall + up),
    ]
    if chance(rng, 0.5):
        points += [(spout * 1.3, tall + up), (spout * 1.3, tall + up + 0.005)]
    return _solid(points, 0.001)


def dome(rng: np.random.Generator, at: Opening) -> Mesh:
    """Rounded or conical cap."""
    radius = at.mouth + max(at.body - at.mouth, 0) * between(rng, 0, 1)
    tall = radius * between(rng, 0.4, 1.8)
    t = np.linspace(0, 1, 9)[:-1]
    power = between(rng, 1.2, 2.6)
    points = [(float(radius * (1 - a**power) ** (1 / power)), float(tall * a)) for a in t]
    return _solid([(radius, -0.006), *points, (radius * 0.08, tall)], 0.0)


def tip(rng: np.random.Generator, at: Opening) -> Mesh:
    """Pointed tip of a squeeze bottle."""
    radius = at.mouth + max(at.body - at.mouth, 0) * between(rng, 0, 0.8)
    base, tall = between(rng, 0.004, 0.02), between(rng, 0.02, 0.07)
    end = between(rng, 0.0015, 0.004)
    return _solid(
        [(radius, -0.004), (radius, base), (radius * between(rng, 0.4, 0.95), base + 0.002), (end, base + tall)], 0.001
    )


def spout(rng: np.random.Generator, at: Opening) -> Mesh:
    """Disc top with a short nozzle."""
    radius, tall = at.mouth + between(rng, 0.001, 0.006), between(rng, 0.01, 0.03)
    nozzle = radius * between(rng, 0.25, 0.7)
    return _solid(
        [(radius, -0.003), (radius, tall), (nozzle, tall + 0.001), (nozzle * 0.8, tall + between(rng, 0.006, 0.02))]
    )


def nipple(rng: np.random.Generator, at: Opening) -> Mesh:
    """Baby bottle: wide collar and teat."""
    collar, tall = at.mouth + between(rng, 0.001, 0.005), between(rng, 0.01, 0.022)
    teat = between(rng, 0.015, 0.032)
    narrow = between(rng, 0.004, 0.008)
    points = [(collar, -0.005), (collar, tall), (collar * 0.75, tall + 0.002), (narrow * 1.3, tall + teat * 0.5)]
    return _solid([*points, (narrow, tall + teat * 0.8), (narrow * 0.6, tall + teat)], 0.004)


def dropper(rng: np.random.Generator, at: Opening) -> Mesh:
    """Dropper with a rubber bulb, or a spray head."""
    collar, tall = at.mouth + between(rng, 0.001, 0.004), between(rng, 0.008, 0.018)
    bulb, up = collar * between(rng, 0.45, 0.8), between(rng, 0.012, 0.035)
    return _solid(
        [(collar, -0.002), (collar, tall), (bulb, tall + 0.002), (bulb, tall + up * 0.7), (bulb * 0.5, tall + up)],
        0.003,
    )


def pump(rng: np.random.Generator, at: Opening) -> Mesh:
    """Pump head; the nozzle stays above the body, so the box stays centred on the axis."""
    collar, tall = at.mouth + between(rng, 0.001, 0.004), between(rng, 0.008, 0.02)
    stem, up = between(rng, 0.003, 0.006), between(rng, 0.006, 0.035)
    head, thick = between(rng, 0.005, 0.013), between(rng, 0.005, 0.013)
    top = tall + up
    turned = _solid(
        [(collar, -0.004), (collar, tall), (stem, tall + 0.002), (stem, top), (head, top), (head, top + thick)]
    )
    reach = at.body * between(rng, 0.75, 0.98)
    if reach <= head:
        return turned
    width = min(between(rng, 0.006, 0.014), 2 * head)
    nozzle = rounded_box((reach, thick * between(rng, 0.5, 0.9), width), between(rng, 2.0, 6.0), 0.001, segments=16)
    lift = top + thick * between(rng, 0.4, 0.6)
    return merged([turned, nozzle.moved(translation=np.array([reach / 2, lift, 0.0]))])


def none(rng: np.random.Generator, at: Opening) -> Mesh:  # noqa: ARG001  a cap like the others
    """Nothing: the mouth is open."""
    return merged([])


CAPS: Mapping[str, CapMaker] = MappingProxyType(
    {
        "screw": screw, "wide": wide, "crown": crown, "foil": foil, "cork": cork, "sport": sport, "dome": dome,
        "tip": tip, "spout": spout, "nipple": nipple, "dropper": dropper, "pump": pump, "open": none,
    }
)  # fmt: skip
