import type { ReadonlySignal } from "@preact/signals";
import { useSignal } from "@preact/signals";
import { Download, FileSpreadsheet, Image, Maximize2, Minimize2 } from "lucide-preact";
import { fileName, saveFile } from "../app/save_file";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import type { Stretch } from "../run/playback";
import type { Samples } from "../run/samples";
import { ChartBox } from "./ChartBox";
import type { Hand } from "./chart";
import { csvOf } from "./csv";
import { FIGURES, type FigureName } from "./figures";
import { Legend } from "./Legend";
import { pictureOf } from "./picture";

/** The measurements of a run, live or recorded, and the moment that is looked at. */
export interface PlotSource {
  readonly samples: Samples;
  readonly stretches: readonly Stretch[];
  /** Changes when there is more to draw. */
  readonly revision: ReadonlySignal<number>;
  /** A tick, or null where none is pointed at. */
  readonly moment: ReadonlySignal<number | null>;
  readonly hand: Hand;
  /** What the program is called. */
  name(): string;
}

interface PlotsPanelProps {
  source: PlotSource;
  tall: boolean;
  onTall(tall: boolean): void;
}

/** The plots of a run, one at a time, and the ways to take them along. */
export function PlotsPanel({ source, tall, onTall }: PlotsPanelProps) {
  const figure = useSignal<FigureName>("path");
  const saving = useSignal(false);
  const { plots } = texts.value;
  const more = source.revision.value;
  return (
    <section class="plots card" aria-label={plots.label} data-testid={TEST.plots} data-more={more}>
      <div class="text__head">
        <Tabs
          chosen={figure.value}
          onChoose={(name) => {
            figure.value = name;
          }}
        />
        <div class="plots__tools">
          <button
            type="button"
            class="button button--plain button--icon"
            aria-label={plots.save}
            title={plots.save}
            aria-expanded={saving.value}
            data-testid={TEST.plotSave}
            onClick={() => {
              saving.value = !saving.value;
            }}
          >
            <Download class="icon" aria-hidden="true" />
          </button>
          <Size tall={tall} onTall={onTall} />
        </div>
      </div>
      {saving.value && <Save source={source} figure={figure.value} />}
      {source.samples.rows === 0 ? (
        <p class="plots__empty">{plots.empty}</p>
      ) : (
        <>
          <Legend source={source} figure={figure.value} />
          <ChartBox source={source} figure={figure.value} />
        </>
      )}
    </section>
  );
}

function Size({ tall, onTall }: Pick<PlotsPanelProps, "tall" | "onTall">) {
  const { plots } = texts.value;
  const label = tall ? plots.smaller : plots.larger;
  const Icon = tall ? Minimize2 : Maximize2;
  return (
    <button
      type="button"
      class="button button--plain button--icon"
      aria-label={label}
      title={label}
      data-testid={TEST.plotSize}
      onClick={() => onTall(!tall)}
    >
      <Icon class="icon" aria-hidden="true" />
    </button>
  );
}

interface TabsProps {
  chosen: FigureName;
  onChoose(name: FigureName): void;
}

function Tabs({ chosen, onChoose }: TabsProps) {
  const { plots } = texts.value;
  return (
    <div class="text__tabs" role="tablist" aria-label={plots.label} onKeyDown={toOtherTab}>
      {FIGURES.map((name) => (
        <button
          key={name}
          type="button"
          class="text__tab"
          role="tab"
          title={plots.titles[name]}
          aria-selected={chosen === name}
          tabIndex={chosen === name ? 0 : -1}
          data-testid={TEST.plotTab}
          data-figure={name}
          onClick={() => onChoose(name)}
        >
          {plots.figures[name]}
        </button>
      ))}
    </div>
  );
}

/** The arrows go from tab to tab, round and round. */
function toOtherTab(event: KeyboardEvent & { currentTarget: HTMLElement }): void {
  const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (!way) return;
  event.stopPropagation();
  const tabs = [...event.currentTarget.querySelectorAll<HTMLElement>("[role=tab]")];
  const now = tabs.findIndex((tab) => tab.ariaSelected === "true");
  const other = tabs.at((now + way) % tabs.length);
  other?.focus();
  other?.click();
}

function Save({ source, figure }: { source: PlotSource; figure: FigureName }) {
  const { plots } = texts.value;
  const base = fileName(source.name(), "pinel");
  const table = () => {
    const csv = csvOf(source.samples, texts.value, language.value);
    saveFile(`${base}.csv`, new Blob([csv], { type: "text/csv;charset=utf-8" }));
  };
  const picture = async () => {
    const about = { figure, name: source.name(), texts: texts.value, language: language.value };
    const image = await pictureOf(source.samples, source.stretches, about);
    const kind = fileName(plots.figures[figure], figure);
    if (image) saveFile(`${base}-${kind}.png`, image);
  };
  const { rows } = source.samples;
  return (
    <div class="plots__save">
      <button
        type="button"
        class="button"
        disabled={rows === 0}
        data-testid={TEST.plotPicture}
        onClick={() => void picture()}
      >
        <Image class="icon" aria-hidden="true" />
        {plots.picture}
      </button>
      <button
        type="button"
        class="button"
        disabled={rows === 0}
        data-testid={TEST.plotTable}
        onClick={table}
      >
        <FileSpreadsheet class="icon" aria-hidden="true" />
        {plots.table}
      </button>
    </div>
  );
}
