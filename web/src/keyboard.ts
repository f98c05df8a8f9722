// Keys that do what buttons do.
import { element } from "./dom";

export interface Shortcut {
  key: string;
  does: string;
  act: () => void;
}

const isTyping = (target: EventTarget | null) =>
  target instanceof HTMLInputElement || target instanceof HTMLSelectElement;

export function install(shortcuts: Shortcut[], list: HTMLDialogElement): void {
  const rows = shortcuts.map(({ key, does }) =>
    element(
      "tr",
      {},
      element("td", {}, element("kbd", { textContent: key === " " ? "Space" : key })),
      element("td", { textContent: does }),
    ),
  );
  list.replaceChildren(element("table", {}, ...rows));
  document.addEventListener("keydown", (event) => {
    if (isTyping(event.target) || event.ctrlKey || event.metaKey || event.altKey) return;
    const shortcut = shortcuts.find(({ key }) => key === event.key);
    if (shortcut === undefined || document.querySelector("dialog[open]") !== null) return;
    event.preventDefault();
    shortcut.act();
  });
}
