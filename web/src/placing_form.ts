// The form beside a box that is being placed: category, part, gizmo, numbers.
import { element, words } from "./dom";
import { WHOLE, type Mode, type Placing } from "./placing";
import type { Category } from "./types";

const MODES: [Mode, string, string][] = [
  ["translate", "Move", "1"],
  ["rotate", "Turn", "2"],
  ["scale", "Stretch", "3"],
];
const CM = 100;
const AXES = ["x", "y", "z"];

type Field = "translation" | "size";

export interface Purpose {
  // What the category may be changed to; one alone where it is given.
  known: Category[];
  fixed: boolean;
  confirm: string;
  choose(category: Category): void;
  cancel(): void;
}

export function showForm(form: HTMLFormElement, placing: Placing, purpose: Purpose): void {
  form.hidden = !placing.active;
  if (!placing.active) return;
  const { category, selected, mode } = placing;
  const shape = JSON.stringify([category, selected, mode, purpose.known, purpose.fixed, purpose.confirm]);
  if (form.dataset.shape !== shape) build(form, placing, purpose);
  form.dataset.shape = shape;
  for (const input of form.querySelectorAll<HTMLInputElement>("input")) {
    const [field, axis] = input.name.split("-") as [Field, string];
    if (input !== document.activeElement) input.value = (CM * valueOf(placing, field, axis)).toFixed(1);
  }
}

// Only when something else than numbers changed: a button that is pressed stays the same until it is let go.
function build(form: HTMLFormElement, placing: Placing, purpose: Purpose): void {
  const [cancel, confirm] = [element("button", { type: "button", onclick: purpose.cancel }), element("button")];
  cancel.append("Cancel", element("kbd", { textContent: "Esc" }));
  Object.assign(confirm, { id: "confirm", className: "primary", type: "submit", textContent: purpose.confirm });
  form.replaceChildren(
    element("label", {}, "Category", categories(placing, purpose)),
    ...(placing.parts.length > 1 ? [element("label", {}, "Part", parts(placing))] : []),
    element("div", { className: "row" }, ...MODES.map(([mode, name, key]) => modeButton(placing, mode, name, key))),
    ...(placing.selected === WHOLE
      ? []
      : [numbers(placing, "translation", "Centre x, y, z (cm)"), numbers(placing, "size", "Size x, y, z (cm)")]),
    element("p", { textContent: advice(placing.category!) }),
    element("div", { className: "row" }, cancel, confirm),
  );
}

function categories(placing: Placing, { known, fixed, choose }: Purpose): HTMLElement {
  const select = element(
    "select",
    { id: "category", disabled: fixed, onchange: () => choose(known.find((each) => each.name === select.value)!) },
    ...known.map((each) =>
      element("option", {
        value: each.name,
        textContent: words(each.name) + (each.trackable ? "" : " (no model here)"),
        disabled: !each.trackable,
        selected: each.name === placing.category!.name,
      }),
    ),
  );
  return select;
}

function parts(placing: Placing): HTMLElement {
  const choices = [
    [WHOLE, "all parts together"] as const,
    ...placing.parts.map((part, i) => [i, words(part.name)] as const),
  ];
  const select = element(
    "select",
    { id: "part", onchange: () => placing.select(Number(select.value)) },
    ...choices.map(([value, textContent]) =>
      element("option", { value: String(value), textContent, selected: placing.selected === value }),
    ),
  );
  return select;
}

function modeButton(placing: Placing, mode: Mode, name: string, key: string): HTMLElement {
  const className = placing.mode === mode ? "on" : "";
  const onclick = () => placing.setMode(mode);
  return element("button", { type: "button", className, onclick }, name, element("kbd", { textContent: key }));
}

function numbers(placing: Placing, field: Field, label: string): HTMLElement {
  const inputs = AXES.map((axis, i) => {
    const input = element("input", {
      type: "number",
      name: `${field}-${axis}`,
      step: field === "size" ? "0.5" : "1",
      ariaLabel: `${field} ${axis}, cm`,
      onchange: () => placing.set(Math.max(0, placing.selected), field, i, Number(input.value) / CM),
    });
    return input;
  });
  return element("label", {}, label, element("div", { className: "row" }, ...inputs));
}

const valueOf = (placing: Placing, field: Field, axis: string): number =>
  placing.parts[Math.max(0, placing.selected)][field][AXES.indexOf(axis)];

function advice(category: Category): string {
  const handle = category.name === "mug" ? ", the handle to +x (red)" : "";
  const alone = category.surroundings ? "" : " Clouds have to hold this object alone.";
  return `Click the cloud to put the box there. y (green) points up the object${handle}. 5° and 3 cm are close enough.${alone}`;
}
