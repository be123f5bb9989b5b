import { Check, LoaderCircle, RefreshCw, TriangleAlert } from "lucide-preact";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { mayPass } from "../../studio/program/autosave";
import { programOnScreen } from "../../studio/program/open_program";

const ICONS = {
  saved: Check,
  saving: LoaderCircle,
  failed: TriangleAlert,
  refused: TriangleAlert,
  deleted: TriangleAlert,
} as const;

/** Shows whether the work is saved on disk. */
export function SaveStatus() {
  const { saved } = texts.value;
  const { value: open } = programOnScreen;
  if (!open) return null;
  const { value: saving } = open.autosave.state;
  const state = saving === "saved" && open.ownWorld.isRefused.value ? "refused" : saving;
  const Icon = ICONS[state];
  const isTried = state === "failed" && mayPass(open.autosave.problem.value);
  return (
    <span
      class={`saved saved--${state === "deleted" ? "failed" : state}`}
      data-testid="saved-mark"
      data-state={state}
    >
      <Icon class="icon" aria-hidden="true" />
      <span role="status" title={isTried ? saved.failedRemedy : undefined}>
        {state === "deleted" ? saved.failed : saved[state]}
      </span>
      {state === "failed" && (
        <Button
          icon={RefreshCw}
          label={saved.retry}
          tip={isTried ? saved.failedRemedy : undefined}
          onPress={() => open.autosave.flush().catch(() => {})}
        >
          <span class="header__word">{saved.retry}</span>
        </Button>
      )}
    </span>
  );
}
