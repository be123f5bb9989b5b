import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { api } from "../api/client";
import type { Group } from "../api/model";
import { group, program, report } from "../app/session";
import { texts } from "../i18n";
import { GroupCard } from "./GroupCard";
import { NewGroup } from "./NewGroup";
import { StartPicture } from "./StartPicture";
import "./start.css";

const SHOWN_AT_FIRST = 11;

/** Who are you? Groups as cards, and one field for a new one. */
export function StartScreen() {
  const groups = useSignal<Group[] | null>(null);
  const shown = useSignal(SHOWN_AT_FIRST);
  useEffect(() => {
    group.value = null;
    program.value = null;
    api.groups().then((found) => {
      groups.value = found;
    }, report);
  }, []);
  if (!groups.value) return <main class="screen" aria-busy="true" />;
  if (groups.value.length === 0) return <FirstGroup />;
  const { start } = texts.value;
  return (
    <main class="screen start">
      <h1 class="start__title">{start.title}</h1>
      <ul class="start__groups" aria-label={start.groups}>
        <li>
          <NewGroup />
        </li>
        {groups.value.slice(0, shown.value).map((one) => (
          <li key={one.id}>
            <GroupCard group={one} />
          </li>
        ))}
      </ul>
      {groups.value.length > shown.value && (
        <button
          type="button"
          class="button start__more"
          onClick={() => {
            shown.value += 24;
          }}
        >
          {start.more}
        </button>
      )}
    </main>
  );
}

function FirstGroup() {
  const { start } = texts.value;
  return (
    <main class="screen start start--first">
      <StartPicture />
      <div class="start__welcome">
        <h1 class="start__title">{start.firstTitle}</h1>
        <p class="start__hint">{start.firstHint}</p>
        <NewGroup first />
      </div>
    </main>
  );
}
