import { texts } from "../../i18n";
import { setTurnMinutes, TURN_MINUTES, turnMinutes } from "../../shell/turns";

/** Selects the interval of the reminder to swap. */
export function TurnMinutes() {
  const { computer: say } = texts.value.teacher;
  return (
    <section class="panel card">
      <fieldset class="turn-choice">
        <legend>
          <h2>{say.turns}</h2>
        </legend>
        {TURN_MINUTES.map((minutes) => (
          <label
            key={minutes}
            class="turn-choice__one"
            data-testid="swap-every"
            data-minutes={minutes}
          >
            <input
              type="radio"
              name="turns"
              checked={turnMinutes.value === minutes}
              onChange={() => setTurnMinutes(minutes)}
            />
            {minutes === 0 ? say.never : say.every(minutes)}
          </label>
        ))}
      </fieldset>
      <p class="labelled__hint">{say.turnsHint}</p>
    </section>
  );
}
