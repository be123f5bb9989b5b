import { useSignal } from "@preact/signals";
import { exchange, type Places } from "../api/exchange";
import { type Problem, wordsOf } from "../app/session";
import { asTeacher } from "../app/teacher";
import { TEST } from "../app/testids";
import { words } from "./words";

interface Properties {
  path: string;
  /** Whether it answers now. */
  isReachable: boolean;
  onChoose(): void;
  onChosen(places: Places): void;
}

/** A folder of the network that is treated as a stick. */
export function SharedFolder({ path, isReachable, onChoose, onChosen }: Properties) {
  const typed = useSignal(path);
  const problem = useSignal<Problem | null>(null);
  const say = words.value;

  const keep = async () => {
    problem.value = null;
    onChoose();
    try {
      onChosen(await asTeacher(() => exchange.share(typed.value.trim())));
    } catch (error) {
      problem.value = wordsOf(error);
    }
  };

  const silent = path !== "" && !isReachable && typed.value === path;
  const fault = problem.value ?? (silent ? say.sharedSilent : null);
  return (
    <form
      class="exchange__box"
      onSubmit={(event) => {
        event.preventDefault();
        void keep();
      }}
    >
      <h2>
        <label for="shared-folder">{say.shared}</label>
      </h2>
      <p id="shared-folder-hint" class="exchange__none">
        {say.sharedHint}
      </p>
      <div class="exchange__buttons">
        <input
          id="shared-folder"
          class="field exchange__path"
          data-testid={TEST.sharedFolder}
          aria-describedby="shared-folder-hint"
          aria-invalid={fault !== null}
          placeholder={say.sharedExample}
          autocomplete="off"
          spellcheck={false}
          value={typed.value}
          onInput={(event) => {
            problem.value = null;
            typed.value = event.currentTarget.value;
          }}
        />
        <button type="submit" class="button">
          {say.keepShared}
        </button>
      </div>
      <p role="alert" class="exchange__problem">
        {fault && `${fault.message} ${fault.remedy}`}
      </p>
    </form>
  );
}
