// A list of cards that stay the same elements while what they say changes: nothing is replaced under a finger.
import { element } from "./dom";

export interface Card {
  key: string;
  title: string;
  side?: string;
  detail: string;
  on: boolean;
  disabled?: boolean;
  state?: string;
  share?: number; // of the bar, from 0 to 1
  act: () => void;
}

export class CardList {
  private views = new Map<string, CardView>();

  // `name` is the attribute that bears the key: data-NAME.
  constructor(
    private place: HTMLElement,
    private name: string,
    private otherwise: (Node | string)[],
  ) {
    place.replaceChildren(...this.nothing);
  }

  show(cards: Card[]): void {
    const views = new Map(
      cards.map((card) => [card.key, this.views.get(card.key) ?? new CardView(this.name, card.key)]),
    );
    const same = [...views.keys()].join("\n") === [...this.views.keys()].join("\n");
    this.views = views;
    for (const card of cards) views.get(card.key)!.show(card);
    if (same) return;
    this.place.replaceChildren(...(cards.length > 0 ? [...views.values()].map((view) => view.button) : this.nothing));
  }

  private get nothing(): Node[] {
    return this.otherwise.length > 0 ? [element("p", {}, ...this.otherwise)] : [];
  }
}

class CardView {
  readonly button: HTMLButtonElement;
  private title = element("strong");
  private side = element("em");
  private detail = element("small");
  private bar = element("i");
  private frame = element("span", { className: "bar" }, this.bar);

  constructor(name: string, key: string) {
    const dot = element("span", { className: "dot" });
    this.button = element("button", {}, dot, this.title, this.side, this.detail, this.frame);
    this.button.dataset[name] = key;
  }

  show({ title, side = "", detail, on, disabled = false, state, share, act }: Card): void {
    this.button.className = on ? "card on" : "card";
    this.button.disabled = disabled;
    this.button.onclick = act;
    if (state !== undefined) this.button.dataset.state = state;
    say(this.title, title);
    say(this.side, side);
    say(this.detail, detail);
    this.frame.hidden = share === undefined;
    this.bar.style.width = `${100 * (share ?? 0)}%`;
  }
}

function say(where: HTMLElement, text: string): void {
  if (where.textContent !== text) where.textContent = text;
}
