// Confidence and latency over time.
import uPlot from "uplot";
import { COLOURS, type Result } from "./types";

const SECONDS = 60;
interface Series { times: number[]; confidence: number[]; latency: number[] }

export class Charts {
  private histories = new Map<string, Series>();
  private start = performance.now();
  private plots: uPlot[];
  private shown: Series = { times: [], confidence: [], latency: [] };

  constructor(private now: { confidence: HTMLElement; latency: HTMLElement }, private places: [HTMLElement, HTMLElement]) {
    this.plots = [
      this.plot(places[0], COLOURS.tracking, [0, 1], (v) => v.toFixed(1)),
      this.plot(places[1], COLOURS.recovering, null, (v) => `${v} ms`),
    ];
    new ResizeObserver(() => this.plots.forEach((plot, i) => plot.setSize({ width: this.places[i].clientWidth, height: 106 }))).observe(places[0]);
  }

  add(result: Result): void {
    if (result.seq === null) return;
    const series = this.histories.get(result.session_id) ?? { times: [], confidence: [], latency: [] };
    this.histories.set(result.session_id, series);
    series.times.push((performance.now() - this.start) / 1000);
    series.confidence.push(result.confidence);
    series.latency.push(result.timing_ms.total);
    while (series.times[0] < series.times[series.times.length - 1] - SECONDS) for (const each of Object.values(series)) each.shift();
  }

  show(session: string | null): void {
    this.shown = (session !== null && this.histories.get(session)) || { times: [], confidence: [], latency: [] };
    const { times, confidence, latency } = this.shown;
    this.now.confidence.textContent = confidence.length ? confidence[confidence.length - 1].toFixed(2) : "–";
    this.now.latency.textContent = latency.length ? `${latency[latency.length - 1].toFixed(0)} ms` : "–";
    this.plots[0].setData([times, confidence]);
    this.plots[1].setData([times, latency]);
  }

  private plot(place: HTMLElement, stroke: string, range: [number, number] | null, label: (v: number) => string): uPlot {
    const axis = { stroke: "#8a97a8", grid: { stroke: "#202a35", width: 1 }, ticks: { show: false }, font: "11px 'Inter Variable', sans-serif" };
    return new uPlot({
      width: Math.max(100, place.clientWidth), height: 106, legend: { show: false }, cursor: { show: false }, padding: [10, 8, 0, 0],
      scales: { x: { time: false, range: () => { const end = (performance.now() - this.start) / 1000; return [end - SECONDS, end]; } }, y: { range: range ?? ((_, __, max) => [0, Math.max(20, 1.15 * (max ?? 0))]) } },
      axes: [{ ...axis, size: 22, splits: (_, __, ___, end) => [-45, -30, -15].map((v) => end + v), values: () => ["−45 s", "−30 s", "−15 s"] }, { ...axis, size: 50, space: 30, values: (_, splits) => splits.map(label) }],
      series: [{}, { stroke, width: 1.6, fill: `${stroke}18`, points: { show: false } }],
    }, [[], []], place);
  }
}
