import { useSignal } from "@preact/signals";
import { CameraChoice } from "../camera/CameraChoice";
import { CameraPicture } from "../camera/CameraPicture";
import { CurrentSign } from "../camera/CurrentSign";
import { hasPicture } from "../camera/sight";
import { texts } from "../i18n";
import { useInstance } from "../kit/instance";
import { Tabs } from "../kit/Tabs";
import { Game } from "./Game";
import { Imitation } from "./Imitation";
import { SpelledText } from "./SpelledText";
import { heldPart, Spelling } from "./spelling";
import { Teaching } from "./Teaching";

/** Practice of signs without a program: imitate a letter, see the detected sign, spell a text. */
export function PracticeScreen() {
  const { practice, titles } = texts.value;
  const spelling = useInstance(() => new Spelling());
  const letter = useSignal("A");
  const mode = useSignal<"letters" | "game">("letters");
  const isGame = mode.value === "game";
  const { game } = texts.value;
  return (
    <main class="screen practice">
      <div class="practice__head row middle gap-4">
        <h1 class="practice__title">{titles.practice}</h1>
        <p class="practice__hint">{hasPicture.value && practice.hint}</p>
        <Tabs
          label={game.tabs}
          testId="practice-mode"
          value={mode.value}
          options={[
            ["letters", game.letters],
            ["game", game.title],
          ]}
          onChange={(chosen) => {
            mode.value = chosen;
          }}
        />
        <CameraChoice />
      </div>
      <div class="practice__picture">
        <CameraPicture />
      </div>
      <div class="practice__side column shrinks shrinks-down gap-3">
        {hasPicture.value && <CurrentSignCard spelling={spelling} />}
        {isGame ? (
          <Game spelling={spelling} />
        ) : (
          <>
            <Imitation letter={letter} />
            <Teaching />
          </>
        )}
      </div>
      {!isGame && <SpelledText spelling={spelling} />}
    </main>
  );
}

function CurrentSignCard({ spelling }: { spelling: Spelling }) {
  const { seen, spelled } = texts.value.practice;
  const held = spelling.held.value;
  return (
    <section class="practice__seen card" aria-label={seen}>
      <CurrentSign progress={heldPart(held)} next={held?.isSpelled ? spelled : undefined} />
    </section>
  );
}
