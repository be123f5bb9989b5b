import { useSignal } from "@preact/signals";
import { exchange } from "../../api/exchange";
import type { FolderList } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Form } from "../../kit/Form";
import { useAct } from "../../kit/requests/act";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { TEST } from "../../shell/testids";

interface SharedFolderProps {
  path: string;
  /** Whether it is reachable now. */
  isReachable: boolean;
  onChoose(): void;
  onChosen(places: FolderList): void;
}

/** A network folder that is used like a stick. */
export function SharedFolder({ path, isReachable, onChoose, onChosen }: SharedFolderProps) {
  const typed = useSignal(path);
  const { busy, fault, act, clear } = useAct(asTeacher);
  const say = texts.value.exchange;
  const isSilent = path !== "" && !isReachable && typed.value === path;
  const shown = fault ?? (isSilent ? say.sharedSilent : null);
  const keep = () => {
    onChoose();
    return act(async () => onChosen(await exchange.share(typed.value.trim())));
  };
  return (
    <Form class="panel card" onSubmit={keep}>
      <h2>
        <label for="shared-folder">{say.shared}</label>
      </h2>
      <p id="shared-folder-hint" class="exchange__hint">
        {say.sharedHint}
      </p>
      <div class="button-row">
        <input
          id="shared-folder"
          class="field exchange__path"
          data-testid={TEST.sharedFolder}
          aria-describedby="shared-folder-hint"
          aria-invalid={shown !== null}
          placeholder={say.sharedExample}
          autocomplete="off"
          spellcheck={false}
          value={typed.value}
          onInput={(event) => {
            clear();
            typed.value = event.currentTarget.value;
          }}
        />
        <Button submit busy={busy}>
          {say.keepShared}
        </Button>
      </div>
      <FaultLine fault={shown} />
    </Form>
  );
}
