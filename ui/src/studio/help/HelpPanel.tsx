import { type Signal, useSignal } from "@preact/signals";
import { BookText, Scale, X } from "lucide-preact";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { activitiesApi } from "../../api/activities";
import { type BlockDrawings, drawBlocks } from "../../editor/block_drawings";
import { language, texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { LinkButton } from "../../kit/LinkButton";
import { valueIn } from "../../kit/requests/load_state";
import { useLoaded } from "../../kit/requests/useLoaded";
import { Tabs } from "../../kit/Tabs";
import { SearchField } from "../../manuals/SearchField";
import { helpIsOpen } from "../../shell/help";
import { level, offered } from "../../shell/level";
import { hashOf } from "../../shell/route";
import { theme } from "../../shell/theme";
import type { StudioControl } from "../studio_control";
import { BlockList } from "./BlockList";
import { type HelpContent, HelpContext } from "./help_content";
import { KeyList } from "./KeyList";
import { SearchResults } from "./SearchResults";
import { TaskList } from "./TaskList";
import { TourButton } from "./TourButton";
import { TASK_NAMES } from "./tasks";

const TABS = ["tasks", "blocks", "keys"] as const;
type Tab = (typeof TABS)[number];

/** The help: tasks, blocks of the level and keys, with a search in all of them. */
export function HelpPanel({ control }: { control: StudioControl }) {
  const query = useSignal("");
  const tab = useSignal<Tab>("tasks");
  const content = useContent(control);
  return (
    <HelpContext.Provider value={content}>
      <section
        class="help card column grows shrinks-down"
        aria-label={texts.value.header.help}
        data-testid="help-panel"
        onKeyDown={(event) => event.key === "Escape" && close()}
      >
        <Head query={query} />
        {query.value.trim() ? (
          <div class="help__body">
            <SearchResults query={query.value} />
          </div>
        ) : (
          <>
            <TabRow tab={tab} />
            <div
              class="help__body"
              key={tab.value}
              role="tabpanel"
              // biome-ignore lint/a11y/noNoninteractiveTabindex: a list of keys scrolls and has nothing else to focus
              tabIndex={0}
              aria-label={texts.value.help.tabs[tab.value]}
            >
              <Part tab={tab.value} drawings={content.drawings} />
            </div>
          </>
        )}
      </section>
    </HelpContext.Provider>
  );
}

function close(): void {
  helpIsOpen.value = false;
}

/** Content of all parts of the help; draws the blocks again when their appearance changes. */
function useContent(control: StudioControl): HelpContent {
  const drawings = useMemo(
    () =>
      drawBlocks({
        language: language.value,
        theme: theme.value,
        level: level.value,
        offered: offered.value,
      }),
    [language.value, theme.value, level.value, offered.value],
  );
  const examples = useLoaded(language.value, () => activitiesApi.examples());
  return {
    drawings,
    examples: valueIn(examples) ?? [],
    open: control.open,
    put: (type) => control.editor?.append(type),
  };
}

function Part({ tab, drawings }: { tab: Tab; drawings: BlockDrawings }) {
  if (tab === "tasks") {
    return (
      <>
        <div class="help__ways row wrap gap-2">
          <TourButton />
          <ManualsLink />
        </div>
        <TaskList names={TASK_NAMES} />
      </>
    );
  }
  if (tab === "blocks") return <BlockList drawings={drawings.all} />;
  return (
    <>
      <KeyList query="" />
      <LinkButton icon={Scale} href={hashOf({ screen: "notices" })} testId="help-notices">
        {texts.value.help.notices.link}
      </LinkButton>
    </>
  );
}

function ManualsLink() {
  return (
    <LinkButton
      kind="plain"
      icon={BookText}
      href={hashOf({ screen: "manuals", manual: null, section: null })}
      testId="help-manuals"
    >
      {texts.value.titles.manuals}
    </LinkButton>
  );
}

/** Gets the focus when the help opens, and returns it when the help closes. */
function Head({ query }: { query: Signal<string> }) {
  const { help, trouble } = texts.value;
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => {
    const before = document.activeElement;
    field.current?.focus();
    return () => before instanceof HTMLElement && before.isConnected && before.focus();
  }, []);
  return (
    <div class="help__head row gap-2">
      <SearchField query={query} label={help.search} testId="help-search" elementRef={field} />
      <Button kind="plain" icon={X} label={trouble.close} testId="help-close" onPress={close} />
    </div>
  );
}

function TabRow({ tab }: { tab: Signal<Tab> }) {
  const { help } = texts.value;
  return (
    <Tabs
      label={texts.value.header.help}
      testId="help-tab"
      value={tab.value}
      options={TABS.map((name) => [name, help.tabs[name], { "data-tab": name }])}
      onChange={(selected) => {
        tab.value = selected;
      }}
    />
  );
}
