import { type Signal, useSignal } from "@preact/signals";
import { ChevronDown, Save } from "lucide-preact";
import { type Bundle, exchange, type Folder } from "../api/exchange";
import type { Classroom } from "../api/model";
import { toldApart } from "../app/namesakes";
import { report } from "../app/session";
import { asTeacher } from "../app/teacher";
import { TEST } from "../app/testids";
import { language } from "../i18n";
import { words } from "./words";

/** A file that was written, and where. */
export interface Saved {
  bundle: Bundle;
  folder: Folder;
}

interface Properties {
  folders: readonly Folder[];
  classes: readonly Classroom[];
  saved: Signal<Saved | null>;
  onSaved(): void;
}

/** Takes the work of this PC, or of one class, along. */
export function SaveBox({ folders, classes, saved, onSaved }: Properties) {
  const classroom = useSignal("");
  const anonymous = useSignal(false);
  const saving = useSignal<string | null>(null);
  const say = words.value;
  const writable = folders.filter((folder) => folder.is_writable);
  if (writable.length === 0) return null;

  const save = async (folder: Folder) => {
    saving.value = folder.path;
    saved.value = null;
    try {
      const bundle = await asTeacher(() =>
        exchange.write(folder.path, classroom.value || null, anonymous.value),
      );
      saved.value = bundle && { bundle, folder };
      onSaved();
    } finally {
      saving.value = null;
    }
  };

  return (
    <section class="exchange__box" aria-labelledby="exchange-save">
      <h2 id="exchange-save">{say.saveHere}</h2>
      {classes.length > 0 && (
        <label class="exchange__what">
          {say.what}
          <span class="select">
            <select
              value={classroom.value}
              onChange={(event) => {
                classroom.value = event.currentTarget.value;
              }}
            >
              <option value="">{say.everything}</option>
              {toldApart(classes, language.value).map((one) => (
                <option key={one.id} value={one.id}>
                  {say.onlyClass(one.name)}
                </option>
              ))}
            </select>
            <ChevronDown class="icon icon--end" aria-hidden="true" />
          </span>
        </label>
      )}
      <label class="exchange__file">
        <input
          type="checkbox"
          checked={anonymous.value}
          onChange={(event) => {
            anonymous.value = event.currentTarget.checked;
          }}
        />
        <span class="exchange__name">{say.anonymous}</span>
        <span class="exchange__about">{say.anonymousHint}</span>
      </label>
      <div class="exchange__buttons">
        {writable.map((folder) => (
          <button
            key={folder.path}
            type="button"
            class="button"
            data-testid={TEST.saveBundle}
            disabled={saving.value !== null}
            onClick={() => void save(folder).catch(report)}
          >
            <Save class="icon" aria-hidden="true" />
            {saving.value === folder.path ? say.saving : say.saveIn(folder.name)}
          </button>
        ))}
      </div>
      <p role="status" class="exchange__saved">
        {saved.value && savedWords(saved.value)}
      </p>
    </section>
  );
}

function savedWords({ bundle, folder }: Saved): string {
  const { name, n_groups, n_runs, left_out } = bundle;
  const say = words.value;
  const saved = say.saved(name, say.groups(n_groups), say.runs(n_runs));
  const missing = left_out && `${left_out.message} ${left_out.remedy}`;
  return [saved, missing, folder.is_stick && say.takeOut].filter(Boolean).join(" ");
}
