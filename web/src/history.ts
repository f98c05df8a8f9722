// What is remembered of every session's last minute.
import type { State } from "./types";

export const LONGEST_S = 60;

export interface Series {
  times: number[];
  confidence: number[];
  latency: number[];
  states: State[];
}

export const now = (): number => performance.now() / 1000;
export const empty = (): Series => ({ times: [], confidence: [], latency: [], states: [] });

export class Histories {
  private all = new Map<string, Series>();

  add(session: string, state: State, confidence: number, latency: number): void {
    const series = this.of(session);
    this.all.set(session, series);
    series.times.push(now());
    series.confidence.push(confidence);
    series.latency.push(latency);
    series.states.push(state);
    const old = series.times.findIndex((time) => time >= now() - LONGEST_S);
    if (old > 0) for (const each of Object.values(series)) each.splice(0, old);
  }

  of(session: string | null): Series {
    return (session !== null && this.all.get(session)) || empty();
  }

  keep(sessions: Set<string>): void {
    for (const id of this.all.keys()) if (!sessions.has(id)) this.all.delete(id);
  }
}
