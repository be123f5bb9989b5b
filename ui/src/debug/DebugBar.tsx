import {
  Bot,
  ChevronDown,
  CornerDownRight,
  CornerUpLeft,
  Gauge,
  Redo2,
  StepForward,
} from "lucide-preact";
import { TEST } from "../app/testids";
import { language, texts } from "../i18n";
import { decimal } from "../i18n/format";
import type { StepMode } from "../run/live";
import type { Phase } from "../run/reducer";
import { LIFELIKE, lifelike, SPEEDS, speed } from "./debugging";

interface DebugBarProps {
  phase: Phase;
  /** The run stands inside a function: a step may lead out of it. */
  inFunction: boolean;
  unable: boolean;
  /** Runs the program up to its first block. */
  onBegin(): void;
  onStep(mode: StepMode): void;
}

/** One block at a time, and how fast the simulated robot is. */
export function DebugBar(props: DebugBarProps) {
  const { debug } = texts.value;
  return (
    <section class="debug-bar" aria-label={debug.bar}>
      <Steps {...props} />
      {!isUnderWay(props.phase) && <LifelikeChoice />}
      <span class="select debug-bar__speed">
        <Gauge class="icon" aria-hidden="true" />
        <select
          aria-label={debug.speed}
          title={debug.speed}
          data-testid={TEST.speed}
          value={String(speed.value)}
          onChange={(event) => {
            speed.value = Number(event.currentTarget.value);
          }}
        >
          {SPEEDS.map((factor) => (
            <option key={factor} value={String(factor)}>
              {debug.times(decimal(factor, factor < 1 ? 2 : 0, language.value))}
            </option>
          ))}
        </select>
        <ChevronDown class="icon icon--end" aria-hidden="true" />
      </span>
    </section>
  );
}

/** How true to life the simulated robot is; chosen before a run. */
function LifelikeChoice() {
  const { debug } = texts.value;
  const names = Object.keys(LIFELIKE) as (keyof typeof LIFELIKE)[];
  return (
    <span class="select debug-bar__lifelike">
      <Bot class="icon" aria-hidden="true" />
      <select
        aria-label={debug.lifelike}
        title={`${debug.lifelike}. ${debug[`${lifelike.value}Help`]}`}
        data-testid={TEST.lifelike}
        value={lifelike.value}
        onChange={({ currentTarget: { value } }) => {
          lifelike.value = names.find((name) => name === value) ?? "ideal";
        }}
      >
        {names.map((name) => (
          <option key={name} value={name} title={debug[`${name}Help`]}>
            {debug[name]}
          </option>
        ))}
      </select>
      <ChevronDown class="icon icon--end" aria-hidden="true" />
    </span>
  );
}

const isUnderWay = (phase: Phase) =>
  phase === "running" || phase === "paused" || phase === "starting";

function Steps({ phase, inFunction, unable, onBegin, onStep }: DebugBarProps) {
  const { debug } = texts.value;
  const paused = phase === "paused";
  const idle = phase !== "running" && phase !== "starting" && !paused;
  return (
    <>
      <Step
        testId={TEST.step}
        label={debug.step}
        help={debug.stepHelp}
        Icon={StepForward}
        disabled={idle ? unable : !paused}
        onClick={() => (idle ? onBegin() : onStep("into"))}
      />
      {paused && (
        <Step
          testId={TEST.stepOver}
          label={debug.over}
          help={debug.overHelp}
          Icon={inFunction ? Redo2 : CornerDownRight}
          disabled={false}
          onClick={() => onStep("over")}
        />
      )}
      {paused && inFunction && (
        <Step
          testId={TEST.stepOut}
          label={debug.out}
          help={debug.outHelp}
          Icon={CornerUpLeft}
          disabled={false}
          onClick={() => onStep("out")}
        />
      )}
    </>
  );
}

interface StepProps {
  testId: string;
  label: string;
  help: string;
  Icon: typeof StepForward;
  disabled: boolean;
  onClick(): void;
}

function Step({ testId, label, help, Icon, disabled, onClick }: StepProps) {
  return (
    <button
      type="button"
      class="button"
      data-testid={testId}
      title={help}
      disabled={disabled}
      onClick={onClick}
    >
      <Icon class="icon" aria-hidden="true" />
      {label}
    </button>
  );
}
