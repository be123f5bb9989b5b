import { type Signal, useSignal } from "@preact/signals";
import { Save } from "lucide-preact";
import { exchange } from "../../api/exchange";
import type { Bundle, Classroom, Folder, Notice } from "../../api/model";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Unbroken } from "../../kit/requests/Unbroken";
import { Select, type SelectOption } from "../../kit/Select";
import { withDistinctNames } from "../../shell/namesakes";
import { asTeacher } from "../../shell/teacher/teacher_session";

/** A written file and its folder. */
export interface Saved {
  bundle: Bundle;
  folder: Folder;
}

interface SaveBoxProps {
  folders: readonly Folder[];
  classes: readonly Classroom[];
  saved: Signal<Saved | null>;
  onSaved(): Promise<void>;
}

/** Exports the work of this PC, or of one class, to a stick. */
export function SaveBox({ folders, classes, saved, onSaved }: SaveBoxProps) {
  const classroom = useSignal("");
  const anonymous = useSignal(false);
  const labels = texts.value.exchange;
  const writable = folders.filter((folder) => folder.is_writable);
  const save = async (folder: Folder) => {
    saved.value = null;
    const bundle = await asTeacher(() =>
      exchange.write(folder.path, classroom.value || null, anonymous.value),
    );
    saved.value = bundle && { bundle, folder };
    void onSaved();
  };
  if (writable.length === 0) return null;
  return (
    <section class="panel card" aria-labelledby="exchange-save">
      <h2 id="exchange-save">{labels.saveHere}</h2>
      {classes.length > 0 && <What classes={classes} chosen={classroom} />}
      <label class="exchange__file">
        <input
          type="checkbox"
          checked={anonymous.value}
          onChange={(event) => {
            anonymous.value = event.currentTarget.checked;
          }}
        />
        <span class="exchange__name">{labels.anonymous}</span>
        <span class="exchange__about">{labels.anonymousHint}</span>
      </label>
      <SaveButtons folders={writable} onSave={save} />
      <p role="status" class="exchange__saved">
        {saved.value && savedText(saved.value)}
      </p>
      {saved.value?.bundle.left_out && <LeftOut of={saved.value.bundle.left_out} />}
    </section>
  );
}

/** Notice about work that the file lacks, because other PCs would refuse it. */
function LeftOut({ of: { message, remedy } }: { of: Notice }) {
  return (
    <p role="alert" class="notice-box" data-testid="export-left-out">
      <b>{message}</b> <Unbroken text={remedy} />
    </p>
  );
}

interface WhatProps {
  classes: readonly Classroom[];
  chosen: Signal<string>;
}

function What({ classes, chosen }: WhatProps) {
  const labels = texts.value.exchange;
  return (
    <label class="button-row">
      {labels.what}
      <Select
        value={chosen.value}
        options={[
          ["", labels.everything],
          ...withDistinctNames(classes, language.value).map(
            ({ id, name }): SelectOption<string> => [id, labels.onlyClass({ name })],
          ),
        ]}
        onChange={(id) => {
          chosen.value = id;
        }}
      />
    </label>
  );
}

interface SaveButtonsProps {
  folders: readonly Folder[];
  onSave(folder: Folder): Promise<void>;
}

/** A button for each folder; one file is written at a time. */
function SaveButtons({ folders, onSave }: SaveButtonsProps) {
  const saving = useSignal<string | null>(null);
  const labels = texts.value.exchange;
  const save = async (folder: Folder) => {
    saving.value = folder.path;
    await onSave(folder).finally(() => {
      saving.value = null;
    });
  };
  return (
    <div class="button-row">
      {folders.map((folder) => (
        <Button
          key={folder.path}
          icon={Save}
          testId="save-bundle"
          busy={saving.value !== null}
          onPress={() => save(folder)}
        >
          {saving.value === folder.path ? labels.saving : labels.saveIn({ folder: folder.name })}
        </Button>
      ))}
    </div>
  );
}

function savedText({ bundle, folder }: Saved): string {
  const { name, n_groups, n_runs } = bundle;
  const labels = texts.value.exchange;
  const saved = labels.saved({
    name,
    groups: labels.groups({ count: n_groups }),
    runs: labels.runs({ count: n_runs }),
  });
  return [saved, folder.is_removable && labels.takeOut].filter(Boolean).join(" ");
}
