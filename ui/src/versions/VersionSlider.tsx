import { ChevronLeft, ChevronRight, CircleCheck, Flag } from "lucide-preact";
import type { VersionSummary } from "../api/model";

import { language, texts } from "../i18n";
import { Button } from "../kit/Button";
import type { VersionHistory } from "./history";
import { versionsIn } from "./line";
import { dayText, versionLine } from "./version_texts";

/** Minimum length of a day that gets a label below it, as a fraction of the line. */
const ROOM = 0.1;

/** Overview of all versions: lessons as sections, with marks at versions that ran, passed or have a name. */
export function VersionSlider({ history }: { history: VersionHistory }) {
  const labels = texts.value.archive;
  const { value: line } = history.line;
  const { value: place } = history.position;
  const last = line.length - 1;
  const chosen = line[place];
  const stepper = (by: number, label: string, testId: string, Icon: typeof ChevronLeft) => (
    <Button
      icon={Icon}
      label={label}
      testId={testId}
      disabled={place + by < 0 || place + by > last}
      onPress={() => history.step(by)}
    />
  );
  return (
    <div class="transport versions__transport row middle gap-3">
      <div class="transport__steps row gap-1">
        {stepper(-1, labels.older, "version-older", ChevronLeft)}
        <span class="versions__place">{labels.of({ n: place + 1, all: line.length })}</span>
        {stepper(1, labels.newer, "version-newer", ChevronRight)}
      </div>
      <div class="slider versions__slider">
        <div class="slider__track" aria-hidden="true">
          <Stretches history={history} />
        </div>
        <div class="versions__marks" aria-hidden="true">
          {line.map((version, index) => (
            <MarkAt key={version.id} version={version} at={last > 0 ? index / last : 0.5} />
          ))}
        </div>
        <input
          class="slider__input"
          type="range"
          min={0}
          max={Math.max(1, last)}
          step={1}
          value={place}
          disabled={last < 1}
          aria-label={labels.line}
          aria-valuetext={chosen && versionLine(chosen, language.value, texts.value)}
          data-testid="version-slider"
          onInput={({ currentTarget }) => history.go(Number(currentTarget.value))}
        />
        <div class="versions__days" aria-hidden="true">
          <Stretches history={history} named />
        </div>
      </div>
    </div>
  );
}

function Stretches({ history, named = false }: { history: VersionHistory; named?: boolean }) {
  const last = Math.max(1, history.line.value.length - 1);
  let begin = 0;
  return (
    <>
      {history.sections.value.map((section) => {
        const left = Math.max(0, begin - 0.5) / last;
        begin += versionsIn(section).length;
        const right = Math.min(last, begin - 0.5) / last;
        return (
          <span
            key={section.from}
            class="versions__stretch"
            style={{ left: `${left * 100}%`, width: `${(right - left) * 100}%` }}
          >
            {named && right - left > ROOM && (
              <span>{dayText(section, new Date(), language.value, texts.value)}</span>
            )}
          </span>
        );
      })}
    </>
  );
}

function MarkAt({ version, at }: { version: VersionSummary; at: number }) {
  const { label, n_passed, n_runs } = version;
  if (!label && n_runs === 0) return null;
  const Icon = n_passed > 0 ? CircleCheck : Flag;
  return (
    <span class="versions__mark" style={{ left: `${at * 100}%` }}>
      {n_runs > 0 && <span class="versions__run" />}
      {(label || n_passed > 0) && <Icon class="icon" />}
    </span>
  );
}
