// How far a recording is, and the button that plays it.
import { byId, element } from "./dom";
import type { Player } from "./player";

export function showPlayer(player: Player | null): void {
  byId("player").hidden = player === null;
  if (player === null) return;
  const { clouds, stamps } = player.recording;
  const seconds = (frame: number) => (Number(stamps[frame] - stamps[0]) / 1e9).toFixed(1);
  const label = player.playing ? "Pause" : player.ended ? "Play again" : "Play";
  const button = byId("play");
  if (button.dataset.label !== label) button.replaceChildren(label, element("kbd", { textContent: "Space" }));
  button.dataset.label = label;
  byId<HTMLProgressElement>("progress").value = (player.frame + 1) / clouds.length;
  byId("clock").textContent = `${seconds(player.frame)} / ${seconds(stamps.length - 1)} s`;
}
