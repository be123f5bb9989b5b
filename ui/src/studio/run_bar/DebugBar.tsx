import { Dices, Gauge } from "lucide-preact";
import { language, texts } from "../../i18n";
import { decimal } from "../../i18n/format";
import { Select } from "../../kit/Select";
import { activeRealLink } from "../../run/real/real_robot";
import { isLivePhase } from "../../run/reducer";
import type { OpenProgram } from "../program/open_program";
import { REALISM_PRESETS, type RealismName, realismOf, SPEEDS } from "../program/setup";
import { ActionButton, type ActionsProps } from "./ActionButton";
import { STEPS } from "./actions";
import { ModelChoice } from "./ModelChoice";

/** Single steps, and the speed of the simulated robot. */
export function DebugBar(props: ActionsProps) {
  const { debug } = texts.value;
  const { open } = props.control;
  return (
    <section class="debug-bar row middle gap-2" aria-label={debug.bar}>
      {STEPS.filter(({ isShown }) => isShown(props.state)).map((action) => (
        <ActionButton key={action.name} {...props} action={action} />
      ))}
      {!activeRealLink.value && (
        <>
          {!isLivePhase(props.state.phase) && !open.mission.value && (
            <>
              <ModelChoice open={open} />
              {!open.setup.value.calibrated_robot && <LifelikeChoice open={open} />}
            </>
          )}
          <SpeedChoice open={open} />
        </>
      )}
    </section>
  );
}

/** Selects the speed of simulated time; a real robot runs in real time. */
function SpeedChoice({ open }: { open: OpenProgram }) {
  const { debug } = texts.value;
  return (
    <Select
      class="debug-bar__speed"
      icon={Gauge}
      label={debug.speed}
      tip={debug.speed}
      testId="speed"
      value={open.setup.value.speed}
      options={SPEEDS.map((factor) => [factor, debug.times({ factor: timesOf(factor) })])}
      onChange={(speed) => open.changeSetup({ speed })}
    />
  );
}

const timesOf = (factor: number) => decimal(factor, factor < 1 ? 2 : 0, language.value);

/** Selects preset and feedback of the next simulated run. */
function LifelikeChoice({ open }: { open: OpenProgram }) {
  const { debug } = texts.value;
  const names = Object.keys(REALISM_PRESETS) as RealismName[];
  const now = realismOf(open.setup.value);
  return (
    <Select
      class="debug-bar__lifelike"
      icon={Dices}
      label={debug.lifelike}
      tip={`${debug.lifelike}. ${debug[`${now}Help`]}`}
      testId="lifelike"
      value={now}
      options={names.map((name) => [name, debug[name], { title: debug[`${name}Help`] }])}
      onChange={(name) => open.changeSetup(REALISM_PRESETS[name])}
    />
  );
}
