// How far a recording is, and the button that plays it.
import { byId, element } from "./dom";
import type { Player } from "./player";

export function showPlayer(player: Player | null): void {
  byId("player").hidden = player === null;
  if (player === null) return;
  const { frames } = player.recording;
  const seconds = (frame: number) => (Number(frames[frame].stamp - frames[0].stamp) / 1e9).toFixed(1);
  const label = player.playing ? "Pause" : player.ended ? "Play again" : "Play";
  const button = byId("play");
  if (button.dataset.label !== label) button.replaceChildren(label, element("kbd", { textContent: "Space" }));
  button.dataset.label = label;
  byId<HTMLProgressElement>("progress").value = (player.frame + 1) / frames.length;
  byId("clock").textContent = `${seconds(player.frame)} / ${seconds(frames.length - 1)} s`;
}
