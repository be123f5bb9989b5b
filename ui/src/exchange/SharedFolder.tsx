import { useSignal } from "@preact/signals";
import { exchange, type Folder } from "../api/exchange";
import { type Problem, wordsOf } from "../app/session";
import { asTeacher } from "../app/teacher";
import { TEST } from "../app/testids";
import { words } from "./words";

interface Properties {
  path: string;
  onChosen(folders: Folder[]): void;
}

/** A folder of the network that is treated as a stick. */
export function SharedFolder({ path, onChosen }: Properties) {
  const typed = useSignal(path);
  const problem = useSignal<Problem | null>(null);
  const say = words.value;

  const keep = async () => {
    problem.value = null;
    try {
      onChosen(await asTeacher(() => exchange.share(typed.value.trim())));
    } catch (error) {
      problem.value = wordsOf(error);
    }
  };

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
          aria-invalid={problem.value !== null}
          autocomplete="off"
          spellcheck={false}
          value={typed.value}
          onInput={(event) => {
            typed.value = event.currentTarget.value;
          }}
        />
        <button type="submit" class="button">
          {say.keepShared}
        </button>
      </div>
      <p role="alert" class="exchange__problem">
        {problem.value && `${problem.value.message} ${problem.value.remedy}`}
      </p>
    </form>
  );
}
