"""What sits on a camera's body: hump, grip, dials, flash, windows, eyepiece, display, lugs.

The body's front is at x = 0 and its middle at y = z = 0, as in a plan.
"""

import numpy as np

from captra.data.shapes.camera_lenses import TOWARDS_X
from captra.data.shapes.camera_plans import CameraPlan
from captra.data.shapes.curves import rounded_polyline
from captra.data.shapes.draws import between, chance, pick
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.plates import Rectangle, plate, stacked
from captra.data.shapes.surfaces import box, revolve, rounded_box, superellipsoid
from captra.geometry import axis_angle

TOWARDS_BACK = axis_angle(np.array([0.0, 1, 0]), np.pi) @ TOWARDS_X
"""Carries y to -x."""


def at(x: float, y: float, z: float) -> np.ndarray:
    """A place."""
    return np.array([x, y, z])


def hump(rng: np.random.Generator, plan: CameraPlan) -> tuple[list[Mesh], float]:
    """What stands on the body above the lens, and how high it is."""
    top = plan.height / 2
    if plan.hump == "none":
        return [], 0.0
    if plan.hump == "plate":
        tall, low = between(rng, 0.004, 0.012), top - 0.004
        size = (plan.depth * between(rng, 0.7, 1.05), tall + 0.004, plan.width * between(rng, 0.55, 0.97))
        return [rounded_box(size, 8, 0.002).moved(translation=at(-plan.depth / 2, low + size[1] / 2, 0))], tall
    wide = plan.lens.radius * between(rng, 1.0, 1.9)
    tall = between(rng, 0.3, 0.75) * plan.lens.radius + (0.006 if plan.hump == "prism" else 0.0)
    if plan.hump == "box":
        wide, tall = wide * between(rng, 0.5, 1.0), tall * between(rng, 0.4, 0.8)
    front, back = between(rng, -0.004, 0.02), plan.depth + between(rng, -0.008, 0.006)
    if plan.hump == "box":
        front = between(rng, -0.01, 0.004)
    foot = Rectangle((-back, -wide / 2), (front, wide / 2), 0.004)
    side = wide * (between(rng, 0.12, 0.36) if plan.hump == "prism" else between(rng, 0.04, 0.2))
    roof = foot.inset(between(rng, 0.0, 0.35) * plan.depth, between(rng, 0.002, 0.3) * plan.depth, side)
    low, knee = top - 0.25 * tall, top + between(rng, 0.1, 0.5) * tall
    layers = [(foot, low), (foot, top), (foot.inset(0.001, 0.001, 0.03 * side), knee), (roof, top + tall)]
    if plan.hump == "rounded":
        shoulder = foot.inset(0.25 * 0.3 * plan.depth * 0.3, 0.001, 0.35 * side)
        layers = [(foot, low), (foot, top), (shoulder, top + 0.6 * tall), (roof, top + tall * 0.93)]
        layers.append((roof.shrunk(0.15 * wide * 0.5), top + tall))
    mesh = stacked(layers)
    return [mesh.moved(translation=at(0, 0, plan.lens_z))], tall


def grip(rng: np.random.Generator, plan: CameraPlan) -> list[Mesh]:
    """A handle for the right hand at the front of +z, and a thumb rest behind."""
    if plan.grip == 0:
        return []
    free = plan.width / 2 - (plan.lens_z + plan.lens.radius)
    wide = min(max(free * between(rng, 0.6, 1.0), 0.008), 0.04)
    tall = plan.height * between(rng, 0.75, 1.04)
    deep = plan.grip + 0.7 * plan.depth
    kind = pick(rng, ((3, "column"), (2, "bar")))
    size = (deep, tall, wide)
    column = rounded_box(size, between(rng, 2.3, 5), between(rng, 0.003, 0.012), 24)
    if kind == "bar":
        column = superellipsoid(size, between(rng, 3.5, 7), 24)
    y = -(plan.height - tall) / 2 * between(rng, -0.2, 1.0)
    z = plan.width / 2 - wide / 2 - between(rng, -0.003, 0.004)
    return [column.moved(translation=at(plan.grip - deep / 2, y, z))]


def knobs(rng: np.random.Generator, plan: CameraPlan) -> list[Mesh]:
    """Shutter release and dials on top, mostly towards +z; rewind knob and lever of film cameras."""
    meshes = []
    top = plan.height / 2
    middle = plan.lens_z / 2 + plan.width / 4 + plan.lens.radius / 3
    for k in range(int(rng.integers(0, plan.knobs + 1))):
        radius = min(between(rng, 0.004, 0.012), 0.42 * plan.depth)
        tall = between(rng, 0.002, 0.012)
        side = middle if chance(rng, 0.7) else -middle
        z = np.clip(side + between(rng, -0.022, 0.022), 0.012 - plan.width / 2, plan.width / 2 - 0.012)
        x = -plan.depth * between(rng, 0.3, 0.7) + (0.7 * plan.grip if k == 0 and side > 0 else 0.0)
        outline = np.array([[0, -0.004], [radius, -0.004], [radius * between(rng, 0.8, 1.0), tall], [0, tall]])
        around = 1 + 0.02 * np.cos(8 * np.arange(24) / 24 * 2 * np.pi)
        knob = revolve(rounded_polyline(outline, 0.0008, 3), around if chance(rng, 0.4) else None, 24)
        meshes.append(knob.moved(translation=at(x, top, float(z))))
    if chance(rng, 0.15):
        turn = axis_angle(np.array([0.0, 1, 0]), between(rng, -1, 1))
        lever = rounded_box((0.008, 0.003, 0.03), 4, 0.001, 16).moved(turn)
        meshes.append(lever.moved(translation=at(-0.7 * plan.depth, top + 0.006, plan.width * 0.4)))
    return meshes


def on_top(rng: np.random.Generator, plan: CameraPlan, tall: float) -> list[Mesh]:
    """Hot shoe, a raised or an external flash; rarely more than one of them."""
    level, z = plan.height / 2 + tall, plan.lens_z if tall > 0 else plan.lens_z * between(rng, 0, 1)
    kind = pick(rng, ((4, "none"), (4, "shoe"), (0.6, "pop-up"), (0.4, "external")))
    middle = -plan.depth * between(rng, 0.35, 0.65)
    if kind == "shoe":
        base = box((0.019, 0.003, 0.021)).moved(translation=at(middle, level + 0.0005, z))
        rail = box((0.017, 0.0022, 0.004)).moved(translation=at(middle, level + 0.003, z))
        return [base, *(rail.moved(translation=at(0, 0, s * 0.0085)) for s in (-1, 1))]
    if kind == "pop-up":
        wide, up = plan.lens.radius * between(rng, 0.9, 1.5), between(rng, 0.012, 0.03)
        arm = box((0.012, up, 0.004)).moved(translation=at(middle, level + up / 2, z))
        arms = [arm.moved(translation=at(0, 0, s * wide * 0.4)) for s in (-1, 1)]
        head = rounded_box((between(rng, 0.012, 0.03), 0.013, wide), 5, 0.002, 20)
        return [*arms, head.moved(translation=at(middle + 0.005, level + up, z))]
    if kind == "external":
        size = (between(rng, 0.025, 0.05), between(rng, 0.03, 0.07), between(rng, 0.045, 0.068))
        stem = rounded_box((size[0] * 0.8, size[1], size[2] * 0.85), 6, 0.004, 20)
        head = rounded_box((size[0] * between(rng, 1.2, 2.0), 0.035, size[2]), 8, 0.004, 20)
        up = level + size[1] / 2
        stem, head = stem.moved(translation=at(middle, up, z)), head.moved(translation=at(middle + 0.01, up, z))
        return [stem, head.moved(translation=at(0, size[1] / 2, 0))]
    return []


def front(rng: np.random.Generator, plan: CameraPlan) -> list[Mesh]:
    """Flash window, viewfinder and lamp, a little proud of or round the front; the mount's ring."""
    meshes = []
    for _ in range(int(rng.integers(0, 4))):
        size = (between(rng, 0.003, 0.006), between(rng, 0.004, 0.012), between(rng, 0.006, 0.024))
        y = plan.height * between(rng, 0.25, 0.4)
        z = np.clip(rng.normal(plan.lens_z, 0.3 * plan.width), -0.4 * plan.width, 0.4 * plan.width)
        meshes.append(rounded_box(size, 6, 0.0008, 12).moved(translation=at(0.0, y, float(z))))
    if plan.lens.length > 0.01 and chance(rng, 0.6):
        radius = plan.lens.radius * between(rng, 1.03, 1.25)
        thick = between(rng, 0.001, 0.008)
        disc = revolve(np.array([[0, -0.004], [radius, -0.004], [radius * 0.96, thick], [0, thick]]), segments=32)
        meshes.append(disc.moved(TOWARDS_X, at(0, plan.lens_y, plan.lens_z)))
    return meshes


def back(rng: np.random.Generator, plan: CameraPlan, tall: float) -> list[Mesh]:
    """Eyepiece, display, buttons, thumb rest."""
    meshes, rear = [], -plan.depth
    if tall > 0.006 or chance(rng, 0.3):
        wide, high = between(rng, 0.014, 0.036), between(rng, 0.01, 0.022)
        out = between(rng, 0.002, 0.02)
        cup = plate(Rectangle.centred(high, wide, 0.005), -0.012, out, 0.002).moved(TOWARDS_BACK)
        y = plan.height / 2 + (0.35 * tall if tall > 0 else -0.6 * high)
        meshes.append(cup.moved(translation=at(rear, y, plan.lens_z if tall > 0 else -plan.width * 0.3)))
    if chance(rng, 0.7):
        screen = Rectangle.centred(plan.height * between(rng, 0.5, 0.78), plan.width * between(rng, 0.42, 0.7), 0.003)
        display = plate(screen, -0.008, between(rng, 0.0005, 0.006), 0.0005).moved(TOWARDS_BACK)
        z = -plan.width * between(rng, 0.02, 0.14)
        if chance(rng, 0.04):  # folded out to the left
            display = plate(screen, 0.0, 0.006, 0.001).moved(TOWARDS_BACK)
            z = -plan.width / 2 - (screen.high[1] - screen.low[1]) / 2
        meshes.append(display.moved(translation=at(rear, -plan.height * between(rng, 0.0, 0.08), z)))
    for _ in range(int(rng.integers(0, 5))):
        radius, out = between(rng, 0.002, 0.009), between(rng, 0.0008, 0.002)
        button = revolve(np.array([[0, -0.004], [radius, -0.004], [radius, out], [0, out]]), segments=14)
        y, z = plan.height * between(rng, -0.3, 0.3), plan.width * between(rng, 0.3, 0.42)
        meshes.append(button.moved(TOWARDS_BACK, at(rear, y, z)))
    if chance(rng, 0.2):
        rest = superellipsoid((0.012, plan.height * 0.4, plan.width * 0.16), 3, 14)
        meshes.append(rest.moved(translation=at(rear, plan.height * 0.15, plan.width * 0.36)))
    return meshes


def sides(rng: np.random.Generator, plan: CameraPlan) -> list[Mesh]:
    """Strap lugs at both sides, a socket or plate below."""
    meshes = []
    if chance(rng, 0.55):
        size = (between(rng, 0.002, 0.006), between(rng, 0.004, 0.01), between(rng, 0.004, 0.012))
        lug = superellipsoid(size, between(rng, 2, 4), 12)
        y, x = plan.height * between(rng, 0.2, 0.42), -plan.depth * between(rng, 0.35, 0.65)
        meshes += [lug.moved(translation=at(x, y, s * plan.width / 2)) for s in (-1, 1)]
    if chance(rng, 0.12):
        below = Rectangle.centred(plan.depth * 0.8, plan.width * between(rng, 0.25, 0.8), 0.004)
        foot = plate(below, -between(rng, 0.003, 0.011), 0.003)
        meshes.append(foot.moved(translation=at(-plan.depth / 2, -plan.height / 2, plan.lens_z * 0.5)))
    return meshes
