import { RotateCw } from "lucide-preact";
import type { ComponentChildren } from "preact";
import { texts } from "../../i18n";
import { Button } from "../Button";
import { ToStart } from "../ToStart";

interface NotLoadedProps {
  /** A whole screen, or a part of one. */
  as: "screen" | "part";
  busy?: boolean;
  again(): Promise<void>;
  /** Actions beside "try again"; on a screen by default the link to the start. */
  actions?: ComponentChildren;
}

/** Placeholder for a value that failed to load; the line under the header shows the error. */
export function NotLoaded({
  as,
  busy,
  again,
  actions = as === "screen" && <ToStart />,
}: NotLoadedProps) {
  const { trouble } = texts.value;
  const Place = as === "screen" ? "main" : "div";
  const Title = as === "screen" ? "h1" : "p";
  return (
    <Place class={as === "screen" ? "screen waiting" : "waiting"}>
      <Title class="waiting__title" data-testid="not-loaded">
        {trouble.notLoaded}
      </Title>
      <div class="waiting__ways">
        <Button icon={RotateCw} busy={busy} testId="try-again" onPress={again}>
          {trouble.tryAgain}
        </Button>
        {actions}
      </div>
    </Place>
  );
}
