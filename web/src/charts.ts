// Confidence and latency over time, with a strip of the states below the confidence.
import uPlot from "uplot";
import { LONGEST_S, empty, now, type Series } from "./history";
import { COLOURS } from "./types";

const SHORTEST_S = 8;
const HEIGHT = 112;
const STRIP = 4;
const LATENCY = "#7aa2f7";
const FONT = "11px 'Inter Variable', sans-serif";
const STEPS_S = [1, 2, 5, 10, 15];

interface Look {
  stroke: string;
  range: uPlot.Range.Function | [number, number];
  label: (value: number) => string;
  strip: boolean;
}

export class Charts {
  private series = empty();
  private drawing = false;
  private plots: {
    plot: uPlot;
    place: HTMLElement;
    values: "confidence" | "latency";
    now: HTMLElement;
    unit: string;
  }[];

  constructor(element: (id: string) => HTMLElement) {
    const fraction: Look = { stroke: COLOURS.tracking, range: [0, 1], label: (v) => v.toFixed(1), strip: true };
    const milliseconds: Look = {
      stroke: LATENCY,
      range: (_, __, most) => [0, Math.max(20, 1.15 * (most ?? 0))],
      label: (v) => `${v} ms`,
      strip: false,
    };
    const place = (values: "confidence" | "latency", look: Look, unit: string) => ({
      plot: this.plot(element(values), look),
      place: element(values),
      values,
      now: element(`${values}-now`),
      unit,
    });
    this.plots = [place("confidence", fraction, ""), place("latency", milliseconds, " ms")];
    const sized = new ResizeObserver(() => {
      for (const { plot, place } of this.plots) plot.setSize({ width: place.clientWidth, height: HEIGHT });
    });
    for (const each of this.plots) sized.observe(each.place);
  }

  show(series: Series): void {
    this.series = series;
    if (this.drawing) return;
    this.drawing = true;
    requestAnimationFrame(() => {
      this.drawing = false;
      for (const { plot, values, now, unit } of this.plots) {
        const last = this.series[values].at(-1);
        now.textContent = last === undefined ? "–" : last.toFixed(unit === "" ? 2 : 0) + unit;
        plot.setData([this.series.times, this.series[values]]);
      }
    });
  }

  // From the first of what is remembered, at least a few seconds, at most all.
  private window = (): [number, number] => {
    const end = this.series.times.at(-1) ?? now();
    const seconds = end - (this.series.times[0] ?? end);
    return [end - Math.min(LONGEST_S, Math.max(SHORTEST_S, seconds)), end];
  };

  private plot(place: HTMLElement, look: Look): uPlot {
    const axis: uPlot.Axis = {
      stroke: "#9aa7b8",
      grid: { stroke: "#202a35", width: 1 },
      ticks: { show: false },
      font: FONT,
    };
    const options: uPlot.Options = {
      width: Math.max(100, place.clientWidth),
      height: HEIGHT,
      legend: { show: false },
      cursor: { show: false },
      padding: [8, 18, 0, 0],
      scales: { x: { time: false, range: this.window }, y: { range: look.range } },
      axes: [
        {
          ...axis,
          size: 24,
          gap: 7,
          splits: (_, __, from, to) => ages(to - from).map((age) => to - age),
          values: (plot, splits) => splits.map((v) => age(plot, v)),
        },
        { ...axis, size: 52, space: 30, values: (_, splits) => splits.map(look.label) },
      ],
      series: [{}, { stroke: look.stroke, width: 1.6, fill: `${look.stroke}1c`, points: { show: false } }],
      hooks: look.strip ? { draw: [(plot) => this.strip(plot)] } : {},
    };
    return new uPlot(options, [[], []], place);
  }

  private strip({ ctx, bbox, valToPos }: uPlot): void {
    const { times, states } = this.series;
    const height = STRIP * devicePixelRatio;
    for (let i = 1; i < times.length; i++) {
      const [from, to] = [valToPos(times[i - 1], "x", true), valToPos(times[i], "x", true)];
      ctx.fillStyle = COLOURS[states[i]];
      ctx.fillRect(
        Math.max(bbox.left, from),
        bbox.top + bbox.height,
        Math.max(1, to - Math.max(bbox.left, from)),
        height,
      );
    }
  }
}

const age = (plot: uPlot, value: number): string => {
  const seconds = Math.round((plot.scales.x.max ?? value) - value);
  return seconds === 0 ? "now" : `−${seconds} s`;
};

function ages(seconds: number): number[] {
  const step = STEPS_S.find((each) => seconds / each <= 6) ?? STEPS_S[STEPS_S.length - 1];
  return Array.from({ length: Math.floor(seconds / step + 1e-6) + 1 }, (_, i) => i * step).reverse();
}
