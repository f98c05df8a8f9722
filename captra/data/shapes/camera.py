"""Cameras: y up, the lens towards +x, the photographer's right hand at +z."""

import numpy as np

from captra.data.shapes import camera_details as details
from captra.data.shapes.camera_lenses import TOWARDS_X, bellows, make_lens
from captra.data.shapes.camera_plans import CameraPlan, draw_plan
from captra.data.shapes.draws import between, chance
from captra.data.shapes.mesh import Mesh
from captra.data.shapes.plates import Rectangle, plate
from captra.data.shapes.shape import Shape, rigid_shape
from captra.data.shapes.surfaces import rounded_box


def make_camera(rng: np.random.Generator) -> Shape:
    """Draw a camera: pocket, system, reflex, film, folding or box camera."""
    plan = draw_plan(rng)
    meshes = _body(rng, plan)
    lens = bellows(rng, 0.75 * plan.height, between(rng, 0.03, 0.09)) if plan.folding else make_lens(rng, plan.lens)
    meshes += [mesh.moved(translation=details.at(0, plan.lens_y, plan.lens_z)) for mesh in lens]
    above, tall = details.hump(rng, plan)
    meshes += above
    meshes += details.grip(rng, plan)
    meshes += details.knobs(rng, plan)
    meshes += details.on_top(rng, plan, tall)
    meshes += details.front(rng, plan)
    meshes += details.back(rng, plan, tall)
    meshes += details.sides(rng, plan)
    return rigid_shape("camera", meshes)


def _body(rng: np.random.Generator, plan: CameraPlan) -> list[Mesh]:
    """Rounded seen from above, or rounded seen from the front; a box around the mount now and then."""
    middle = details.at(-plan.depth / 2, 0, 0)
    if chance(rng, 0.65):
        body = rounded_box((plan.depth, plan.height, plan.width), plan.exponent, plan.fillet, 40)
    else:
        corner = between(rng, 0.002, 0.3 * plan.height)
        front = Rectangle.centred(plan.height, plan.width, corner)
        bevel = min(plan.fillet, 0.3 * plan.depth)
        body = plate(front, -plan.depth / 2, plan.depth / 2, bevel).moved(TOWARDS_X)
    meshes = [body.moved(translation=middle)]
    if plan.hump in {"prism", "rounded"} and chance(rng, 0.7):
        side = plan.lens.radius * between(rng, 1.9, 2.3)
        out = min(between(rng, 0.004, 0.02), 0.5 * plan.lens.length)  # the lens stays in sight
        tall = min(side, plan.height * 0.98)
        mount = plate(Rectangle.centred(tall, side, between(rng, 0.003, 0.5 * tall)), -0.01, out, 0.003)
        meshes.append(mount.moved(TOWARDS_X, details.at(0, 0, plan.lens_z)))
    return meshes
