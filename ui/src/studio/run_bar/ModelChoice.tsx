import { Bot } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { texts } from "../../i18n";
import { labelled } from "../../i18n/phrases";
import { settled } from "../../kit/report";
import { Select, type SelectOption } from "../../kit/Select";
import { clear } from "../../run/live";
import {
  calibratedRobots,
  calibratedTitle,
  loadCalibratedRobots,
} from "../../run/real/calibrated_robots";
import { robotModels, robotOf } from "../../shell/session";
import type { OpenProgram } from "../program/open_program";
import { REALISM_PRESETS } from "../program/setup";

/** Selects the model of the simulated robot, or a calibrated robot. */
export function ModelChoice({ open }: { open: OpenProgram }) {
  const { debug, calibration } = texts.value;
  const { model, calibrated_robot: calibrated } = open.setup.value;
  useEffect(() => void settled(loadCalibratedRobots()), []);
  const models = robotModels.value.map(({ name, title }): SelectOption<string> => [name, title]);
  const learned = calibratedOptions(calibrated, calibration.missing);
  const title = calibrated ? calibratedTitle(calibrated) : robotOf(model)?.title;
  return (
    <Select
      class="debug-bar__model"
      icon={Bot}
      label={debug.model}
      tip={labelled(debug.model, title ?? calibration.missing)}
      testId="robot-model"
      value={calibrated ?? model}
      options={models}
      groups={learned.length > 0 ? [[calibration.choice, learned]] : []}
      onChange={(chosen) => {
        choose(open, chosen);
        clear();
      }}
    />
  );
}

/** The calibrated robots; one that the program uses and this PC lacks is among them, so that its absence shows. */
function calibratedOptions(chosen: string | null, missing: string): SelectOption<string>[] {
  const { value: robots } = calibratedRobots;
  const known = (robots ?? []).map(({ id, title }): SelectOption<string> => [id, title]);
  const isMissing = chosen !== null && !known.some(([id]) => id === chosen);
  return isMissing ? [...known, [chosen, robots ? missing : "…"]] : known;
}

/** A calibrated robot is as its report says; with a model the realism stays as it was. */
function choose(open: OpenProgram, chosen: string) {
  const robot = calibratedRobots.peek()?.find(({ id }) => id === chosen);
  const model = robotModels.peek().find(({ name }) => name === chosen);
  if (robot) {
    const { model: of, id } = robot;
    open.changeSetup({ model: of, ...REALISM_PRESETS.wheels, calibrated_robot: id });
  } else if (model) open.changeSetup({ model: model.name, calibrated_robot: null });
}
