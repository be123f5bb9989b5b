import { ArrowDown, ArrowUp, type LucideIcon, RotateCcw, RotateCw } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { listen } from "../../kit/listen";
import { FaultLine } from "../../kit/requests/FaultLine";
import { type Direction, held, hold, jogFault, release } from "../../run/real/jog";
import { robotStates } from "../../run/real/robot_state";

const KEYS: readonly (readonly [Direction, string, LucideIcon])[] = [
  ["ahead", "ArrowUp", ArrowUp],
  ["left", "ArrowLeft", RotateCcw],
  ["right", "ArrowRight", RotateCw],
  ["back", "ArrowDown", ArrowDown],
];

/** Buttons that jog the robot slowly while held; arrow keys do so while a button has the focus. */
export function JogPad({ link }: { link: string }) {
  const { jog: labels } = texts.value.robotSetup;
  useEffect(letGoWithWindow, []);
  const onKey = (event: KeyboardEvent) => {
    const own = (event.target as HTMLElement).dataset.direction as Direction | undefined;
    const isPress = event.key === " " || event.key === "Enter";
    const direction = isPress ? own : KEYS.find(([, key]) => key === event.key)?.[0];
    if (!direction || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    // after an emergency stop a key may still be down: its repetitions must not jog the robot again
    if (!event.repeat) hold(link, direction);
  };
  return (
    <div class="jog">
      <h3 id="jog-title">{labels.title}</h3>
      <p class="teacher__hint">{labels.hint}</p>
      <fieldset
        class="jog__pad"
        aria-labelledby="jog-title"
        onKeyDown={onKey}
        onKeyUp={release}
        onFocusOut={release}
      >
        {KEYS.map(([direction, key, icon]) => (
          <JogKey key={direction} link={link} direction={direction} shortcut={key} icon={icon} />
        ))}
      </fieldset>
      <Moving link={link} />
      <div data-testid="jog-fault">
        <FaultLine fault={jogFault.value} />
      </div>
    </div>
  );
}

interface JogKeyProps {
  link: string;
  direction: Direction;
  shortcut: string;
  icon: LucideIcon;
}

function JogKey({ link, direction, shortcut, icon }: JogKeyProps) {
  return (
    <Button
      class={`jog__key jog__key--${direction}`}
      icon={icon}
      tip={texts.value.robotSetup.jog[direction]}
      label={texts.value.robotSetup.jog[direction]}
      pressed={held.value?.direction === direction}
      testId="jog"
      data-direction={direction}
      aria-keyshortcuts={shortcut}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.focus();
        event.currentTarget.setPointerCapture(event.pointerId);
        hold(link, direction);
      }}
      onPointerUp={release}
      onPointerCancel={release}
      onLostPointerCapture={release}
      onContextMenu={(event) => event.preventDefault()}
    />
  );
}

function Moving({ link }: { link: string }) {
  const { jog: labels } = texts.value.robotSetup;
  const state = robotStates.value[link];
  const isMoved = state?.use === "jog" && state.state === "connected";
  return (
    <p role="status" class="teacher__done">
      {held.value && (isMoved ? labels.moving : labels.connecting)}
    </p>
  );
}

/** Releases the jog key when the window loses the focus or visibility, or at unmount. */
function letGoWithWindow(): () => void {
  const stop = listen(window, { blur: release, pagehide: release, hashchange: release });
  document.addEventListener("visibilitychange", release);
  return () => {
    stop();
    document.removeEventListener("visibilitychange", release);
    release();
  };
}
