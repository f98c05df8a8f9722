// The API key of a guarded service: from #key= in the address, or asked for; kept for this tab alone.
import { element } from "./dom";

const STORED = "captra-key";

export class Keyring {
  private asking: Promise<void> | null = null;

  constructor(private dialog: HTMLDialogElement) {
    const given = new URLSearchParams(location.hash.slice(1)).get("key");
    if (given === null) return;
    sessionStorage.setItem(STORED, given);
    history.replaceState(null, "", location.pathname + location.search); // nobody reads it over a shoulder
  }

  get key(): string | null {
    return sessionStorage.getItem(STORED);
  }

  get headers(): Record<string, string> {
    return this.key === null ? {} : { Authorization: `Bearer ${this.key}` };
  }

  // Browsers cannot give headers to a websocket.
  get query(): string {
    return this.key === null ? "" : `?access_token=${encodeURIComponent(this.key)}`;
  }

  // Resolves once somebody has typed a key; whoever asks meanwhile waits for the same.
  ask(why: string): Promise<void> {
    this.asking ??= new Promise<void>((done) => {
      const input = element("input", { type: "password", autocomplete: "off", required: true, ariaLabel: "API key" });
      const form = element(
        "form",
        { method: "dialog" },
        element("h2", { textContent: "API key" }),
        element("p", { textContent: why }),
        input,
        element("button", { className: "primary", type: "submit", textContent: "Enter" }),
      );
      form.addEventListener("submit", () => {
        sessionStorage.setItem(STORED, input.value.trim());
        this.asking = null;
        done();
      });
      this.dialog.oncancel = (event) => event.preventDefault(); // without a key there is nothing to see
      this.dialog.replaceChildren(form);
      this.dialog.showModal();
    });
    return this.asking;
  }
}
