import { type Signal, useSignal } from "@preact/signals";
import { ArrowLeft, Printer, Save } from "lucide-preact";
import { useRef } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { Choice } from "../../kit/Choice";
import { LinkButton } from "../../kit/LinkButton";
import { Select } from "../../kit/Select";
import { hashOf } from "../../shell/route";
import { savePage } from "../plan/page_file";
import { usePrintedPage } from "../plan/printed_page";
import { canPrint } from "../review/lesson/printing";
import { CardSheet } from "./CardSheet";
import { CARD_LISTS, type CardList } from "./card_lists";

const COPIES = [1, 2, 3, 4, 6, 8] as const;

type Ink = "lines" | "colours";

/** Cards of blocks to cut out, as they come on paper. */
export function CardsScreen() {
  const { plan } = texts.value;
  const say = plan.cards;
  const list = useSignal<CardList>("lesson");
  const copies = useSignal(4);
  const ink = useSignal<Ink>("lines");
  const sheet = useRef<HTMLElement>(null);
  usePrintedPage("cards");
  return (
    <main class="screen cards-screen">
      <div class="review-head cards-screen__head row middle gap-4">
        <LinkButton
          icon={ArrowLeft}
          label={say.back}
          href={hashOf({ screen: "teacher", part: "plan" })}
        />
        <h1>{say.title}</h1>
        <p>{say.about}</p>
        {canPrint() && (
          <Button kind="main" icon={Printer} testId="cards-print" onPress={() => window.print()}>
            {plan.print}
          </Button>
        )}
        <Button
          icon={Save}
          tip={plan.saveHelp}
          testId="cards-save"
          onPress={() => savePage(sheet.current, say.title, say.fileName)}
        >
          {plan.save}
        </Button>
      </div>
      <CardOptions list={list} copies={copies} ink={ink} />
      <CardSheet list={list.value} copies={copies.value} ink={ink.value} elementRef={sheet} />
    </main>
  );
}

interface CardOptionsProps {
  list: Signal<CardList>;
  copies: Signal<number>;
  ink: Signal<Ink>;
}

/** Which cards, how many of each, and in which ink. */
function CardOptions({ list, copies, ink }: CardOptionsProps) {
  const say = texts.value.plan.cards;
  return (
    <div class="cards-screen__options">
      <label class="filters__one">
        <span>{say.which}</span>
        <Select<CardList>
          value={list.value}
          options={CARD_LISTS.map((name) => [name, say.lists[name]])}
          testId="cards-list"
          onChange={(chosen) => {
            list.value = chosen;
          }}
        />
      </label>
      <label class="filters__one">
        <span>{say.copies}</span>
        <Select<number>
          value={copies.value}
          options={COPIES.map((n) => [n, String(n)])}
          testId="cards-copies"
          onChange={(chosen) => {
            copies.value = Number(chosen);
          }}
        />
      </label>
      <Choice<Ink>
        class="switch row middle shrinks"
        label={say.ink}
        legendClass="switch__word"
        optionClass=""
        testId="cards-ink"
        value={ink.value}
        options={[
          ["lines", say.inks.lines],
          ["colours", say.inks.colours],
        ]}
        onChange={(chosen) => {
          ink.value = chosen;
        }}
      />
      <p>{say.printHelp}</p>
    </div>
  );
}
