import { RotateCw, X } from "lucide-preact";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { showSolid, solidEnd } from "./view_mode";

/** Says once why a floor is back in 2D. Where another try may help, it offers one. */
export function SolidEnd({ floor }: { floor: object }) {
  const { value: end } = solidEnd;
  const { solid, trouble, saved } = texts.value;
  const isHere = end?.floor === floor;
  return (
    <div role="status">
      {end && isHere && (
        <div class="scene__end row middle gap-2" data-testid="solid-end" data-problem={end.problem}>
          <p>{solid.ends[end.problem]}</p>
          {end.problem !== "no_webgl" && (
            <Button icon={RotateCw} testId="solid-again" onPress={() => showSolid(true)}>
              {saved.retry}
            </Button>
          )}
          <Button
            kind="plain"
            icon={X}
            label={trouble.close}
            onPress={() => {
              solidEnd.value = null;
            }}
          />
        </div>
      )}
    </div>
  );
}
