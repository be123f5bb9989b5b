import { effect } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import { language, type Texts, texts } from "../i18n";
import { theme } from "../shell/theme";
import type { Chart, ChartOptions, PlotInput } from "./chart";
import { PathChart } from "./path_chart";
import type { PlotSource } from "./plot_source";
import { currentStyle } from "./plot_style";
import { type PlotName, TIME_PLOTS } from "./plots";
import { TimeChart } from "./time_chart";

interface ChartBoxProps {
  source: PlotSource;
  plotName: PlotName;
}

/** Step of an arrow key, in ticks. */
const KEY_TICKS = 3;

/** A plot that fills its container. */
export function ChartBox({ source, plotName }: ChartBoxProps) {
  const box = useRef<HTMLDivElement>(null);
  const { plots } = texts.value;
  // before the next frame, so that a press never meets the axes of the plot before
  useLayoutEffect(() => {
    const element = box.current;
    if (!element) return undefined;
    return drawn(element, source, plotName);
  }, [source, plotName, theme.value, language.value]);
  return (
    <section
      ref={box}
      class="plots__chart grows shrinks-down"
      aria-label={`${plots.titles[plotName]}. ${plots.keys}`}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: the arrow keys move the selected tick
      tabIndex={0}
      data-testid="plot"
      data-figure={plotName}
      data-tick={source.selectedTick.value ?? ""}
      onKeyDown={(event) => goThrough(event, source)}
    />
  );
}

function drawn(element: HTMLElement, source: PlotSource, plotName: PlotName): () => void {
  const { clientWidth, clientHeight } = element;
  const titles = titlesOf(plotName, texts.peek());
  const style = currentStyle();
  const size = { width: clientWidth, height: clientHeight };
  const chartOptions = { style, language: language.peek(), titles, ...size };
  const chart = chartOf(plotName, chartOptions, element, source.input);
  const stopData = effect(() => {
    source.revision.value;
    chart.show(source.samples, source.stretches);
  });
  const stopMoment = effect(() => chart.selectTick(source.selectedTick.value));
  const sizes = new ResizeObserver(() => chart.resize(element.clientWidth, element.clientHeight));
  sizes.observe(element);
  return () => {
    sizes.disconnect();
    stopData();
    stopMoment();
    chart.dispose();
  };
}

export function chartOf(
  plotName: PlotName,
  chartOptions: ChartOptions,
  into: HTMLElement,
  input: PlotInput,
): Chart {
  if (plotName === "path") return new PathChart(chartOptions, into, input);
  return new TimeChart(plotName, chartOptions, into, input);
}

/** Titles of the axes. */
export function titlesOf(plotName: PlotName, { plots }: Texts): readonly [string, string] {
  if (plotName === "path") return ["x (m)", "y (m)"];
  return [`${plots.time} (s)`, `${plots.quantities[plotName]} (${TIME_PLOTS[plotName].unit})`];
}

function goThrough(event: KeyboardEvent, { selectedTick, samples, input }: PlotSource): void {
  const direction = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (!direction) return;
  event.preventDefault();
  event.stopPropagation();
  const last = samples.column("tick").at(-1) ?? 0;
  const now = Math.round(selectedTick.peek() ?? last);
  input.onPress(Math.min(last, Math.max(0, now + direction * KEY_TICKS)));
}
