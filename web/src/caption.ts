// What stands over the view: what it is, how it is, where its parts and joints are, and what to do when nothing is there.
import { byId, element, words } from "./dom";
import type { Joint, Part, Result, State } from "./types";

const DEGREES = 180 / Math.PI;

export function showTitle(name: string, hint: string, state: State | undefined): void {
  const title = byId("title");
  title.replaceChildren(words(name), element("span", { textContent: hint }));
  if (state === undefined) delete title.dataset.state;
  else title.dataset.state = state;
}

export function showEmpty(said: { title: string; text: string } | null): void {
  byId("empty").replaceChildren(
    ...(said === null ? [] : [element("div", {}, element("strong", { textContent: said.title }), said.text)]),
  );
}

export function showParts(result: Result | null): void {
  byId("parts").replaceChildren(
    ...(result === null
      ? []
      : [element("table", {}, headRow(), ...result.parts.map(partRow), ...result.joints.map(jointRow))]),
  );
}

const cell = (text: string) => element("td", { textContent: text });
const heading = (text: string) => element("th", { textContent: text });
// With a proper minus, and none before zero.
const fixed = (value: number, digits: number) =>
  (Math.round(value * 10 ** digits) / 10 ** digits + 0).toFixed(digits).replace("-", "−");

function headRow(): HTMLElement {
  return element("tr", {}, heading(""), heading("centre x, y, z (m)"), heading("size (cm)"));
}

function partRow(part: Part): HTMLElement {
  return element(
    "tr",
    {},
    heading(words(part.name)),
    cell(part.translation.map((v) => fixed(v, 3)).join("  ")),
    cell(part.size.map((v) => fixed(100 * v, 1)).join(" × ")),
  );
}

function jointRow(joint: Joint): HTMLElement {
  const value = joint.kind === "revolute" ? `${fixed(joint.value * DEGREES, 1)}°` : `${fixed(100 * joint.value, 1)} cm`;
  return element("tr", {}, heading(words(joint.name)), cell(value));
}
