import { useSignal } from "@preact/signals";
import { exchange } from "../../api/exchange";
import type { FolderList } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Form } from "../../kit/Form";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { asTeacher } from "../../shell/teacher/teacher_session";

interface SharedFolderProps {
  path: string;
  /** Whether the folder gets copies of this PC's backups. */
  storesBackups: boolean;
  /** Whether the folder is reachable now. */
  isReachable: boolean;
  onChoose(): void;
  onChosen(places: FolderList): void;
}

/** A network folder, used like a stick. */
export function SharedFolder(props: SharedFolderProps) {
  const { path, storesBackups, isReachable, onChoose, onChosen } = props;
  const typed = useSignal(path);
  const ticked = useSignal(storesBackups);
  const { busy, fault, act, clear } = useAction(asTeacher);
  const labels = texts.value.exchange;
  const isUnreachable = path !== "" && !isReachable && typed.value === path;
  const shown = fault ?? (isUnreachable ? labels.sharedSilent : null);
  const save = () => {
    onChoose();
    return act(async () => onChosen(await exchange.share(typed.value.trim())));
  };
  const tick = async (isTicked: boolean) => {
    ticked.value = isTicked;
    const isSaved = await act(async () => onChosen(await exchange.shareBackups(path, isTicked)));
    if (!isSaved) ticked.value = !isTicked;
  };
  return (
    <Form class="panel card" onSubmit={save}>
      <h2>
        <label for="shared-folder">{labels.shared}</label>
      </h2>
      <p id="shared-folder-hint" class="exchange__hint">
        {labels.sharedHint}
      </p>
      <div class="button-row">
        <input
          id="shared-folder"
          class="field exchange__path"
          data-testid="shared-folder"
          aria-describedby="shared-folder-hint"
          aria-invalid={shown !== null}
          placeholder={labels.sharedExample}
          autocomplete="off"
          spellcheck={false}
          value={typed.value}
          onInput={(event) => {
            clear();
            typed.value = event.currentTarget.value;
          }}
        />
        <Button submit busy={busy}>
          {labels.keepShared}
        </Button>
      </div>
      {path !== "" && <BackupsTick isTicked={ticked.value} onTick={tick} />}
      <FaultLine fault={shown} />
    </Form>
  );
}

interface BackupsTickProps {
  isTicked: boolean;
  onTick(isTicked: boolean): void;
}

/** Check box: whether the folder also gets copies of this PC's backups. */
function BackupsTick({ isTicked, onTick }: BackupsTickProps) {
  const labels = texts.value.exchange;
  return (
    <label class="exchange__file">
      <input
        type="checkbox"
        data-testid="shared-backups"
        checked={isTicked}
        onChange={(event) => onTick(event.currentTarget.checked)}
      />
      <span class="exchange__name">{labels.sharedBackups}</span>
      <span class="exchange__about">{labels.sharedBackupsHint}</span>
    </label>
  );
}
