import { useSignal } from "@preact/signals";
import { Download, FileSpreadsheet, Image, Maximize2, Minimize2 } from "lucide-preact";
import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import { Tabs } from "../kit/Tabs";
import { fileName, saveFile } from "../shell/files/save_file";
import { ChartBox } from "./ChartBox";
import { csvOf } from "./csv";
import { Legend } from "./Legend";
import { pictureOf } from "./picture";
import type { PlotSource } from "./plot_source";
import { PLOTS, type PlotName } from "./plots";

interface PlotsPanelProps {
  source: PlotSource;
  tall: boolean;
  onTall(tall: boolean): void;
}

/** The plots of a run, one at a time, with buttons to export them. */
export function PlotsPanel({ source, tall, onTall }: PlotsPanelProps) {
  const plotName = useSignal<PlotName>("path");
  const saving = useSignal(false);
  const { plots } = texts.value;
  const more = source.revision.value;
  return (
    <section
      class="plots card column shrinks-down"
      aria-label={plots.label}
      data-testid="plots"
      data-more={more}
    >
      <div class="text__head row middle apart rigid gap-2">
        <Tabs
          label={plots.label}
          testId="plot-tab"
          value={plotName.value}
          options={PLOTS.map((name) => [
            name,
            plots.figures[name],
            { title: plots.titles[name], "data-figure": name },
          ])}
          onChange={(name) => {
            plotName.value = name;
          }}
        />
        <div class="row rigid">
          <Button
            icon={Download}
            label={plots.save}
            kind="plain"
            open={saving.value}
            testId="plot-save"
            onPress={() => {
              saving.value = !saving.value;
            }}
          />
          <Size tall={tall} onTall={onTall} />
        </div>
      </div>
      {saving.value && <Save source={source} plotName={plotName.value} />}
      {source.samples.rows === 0 ? (
        <p class="plots__empty">{plots.empty}</p>
      ) : (
        <>
          <Legend source={source} plotName={plotName.value} />
          <ChartBox source={source} plotName={plotName.value} />
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
    <Button
      icon={Icon}
      label={label}
      kind="plain"
      testId="plot-size"
      onPress={() => onTall(!tall)}
    />
  );
}

function Save({ source, plotName }: { source: PlotSource; plotName: PlotName }) {
  const { plots } = texts.value;
  const base = fileName(source.name(), "pinel");
  const table = () => {
    const csv = csvOf(source.samples, texts.value, language.value);
    saveFile(`${base}.csv`, new Blob([csv], { type: "text/csv;charset=utf-8" }));
  };
  const picture = async () => {
    const about = { plotName, name: source.name(), texts: texts.value, language: language.value };
    const image = await pictureOf(source.samples, source.stretches, about);
    const kind = fileName(plots.figures[plotName], plotName);
    if (image) saveFile(`${base}-${kind}.png`, image);
  };
  const { rows } = source.samples;
  return (
    <div class="plots__save row wrap rigid gap-2">
      <Button icon={Image} disabled={rows === 0} testId="plot-picture" onPress={picture}>
        {plots.picture}
      </Button>
      <Button icon={FileSpreadsheet} disabled={rows === 0} testId="plot-table" onPress={table}>
        {plots.table}
      </Button>
    </div>
  );
}
