import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { language, type Texts, texts } from "../i18n";
import { theme } from "../shell/theme";
import type { Chart, PlotInput, Setting } from "./chart";
import { type FigureName, TIME_FIGURES } from "./figures";
import { readLook } from "./look";
import { PathChart } from "./path_chart";
import type { PlotSource } from "./plot_source";
import { TimeChart } from "./time_chart";

interface ChartBoxProps {
  source: PlotSource;
  figure: FigureName;
}

/** Step of an arrow key, in ticks. */
const KEY_TICKS = 3;

/** A plot that fills its container. */
export function ChartBox({ source, figure }: ChartBoxProps) {
  const box = useRef<HTMLDivElement>(null);
  const { plots } = texts.value;
  useEffect(() => {
    const element = box.current;
    if (!element) return undefined;
    return drawn(element, source, figure);
  }, [source, figure, theme.value, language.value]);
  return (
    <section
      ref={box}
      class="plots__chart grows shrinks-down"
      aria-label={`${plots.titles[figure]}. ${plots.keys}`}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: the arrows go through its moments
      tabIndex={0}
      data-testid="plot"
      data-figure={figure}
      data-tick={source.moment.value ?? ""}
      onKeyDown={(event) => goThrough(event, source)}
    />
  );
}

function drawn(element: HTMLElement, source: PlotSource, figure: FigureName): () => void {
  const { clientWidth, clientHeight } = element;
  const titles = titlesOf(figure, texts.peek());
  const look = readLook();
  const size = { width: clientWidth, height: clientHeight };
  const setting = { look, language: language.peek(), titles, ...size };
  const chart = chartOf(figure, setting, element, source.input);
  const stopData = effect(() => {
    source.revision.value;
    chart.show(source.samples, source.stretches);
  });
  const stopMoment = effect(() => chart.mark(source.moment.value));
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
  figure: FigureName,
  setting: Setting,
  into: HTMLElement,
  input: PlotInput,
): Chart {
  if (figure === "path") return new PathChart(setting, into, input);
  return new TimeChart(figure, setting, into, input);
}

/** Titles of the axes. */
export function titlesOf(figure: FigureName, { plots }: Texts): readonly [string, string] {
  if (figure === "path") return ["x (m)", "y (m)"];
  return [`${plots.time} (s)`, `${plots.quantities[figure]} (${TIME_FIGURES[figure].unit})`];
}

function goThrough(event: KeyboardEvent, { moment, samples, input }: PlotSource): void {
  const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (!way) return;
  event.preventDefault();
  event.stopPropagation();
  const last = samples.column("tick").at(-1) ?? 0;
  const now = Math.round(moment.peek() ?? last);
  input.onPress(Math.min(last, Math.max(0, now + way * KEY_TICKS)));
}
