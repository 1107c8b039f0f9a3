// The explorer: tabs over one state, which the address keeps.
import { ChartsView } from "./charts/chartsView";
import { Campaign, type Runs } from "./data/campaign";
import { choice, el } from "./page/dom";
import { Overview } from "./page/overview";
import { State, type View } from "./page/state";
import { onSystemTheme, themeOf } from "./page/theme";
import { PlayerView } from "./player/playerView";
import { RunsView } from "./runs/runsView";

const kTitles: Record<View, string> = {
    overview: "Overview",
    charts: "Charts",
    runs: "Runs",
    player: "Player",
};

class Page {
    private readonly views: Record<View, { element: HTMLElement; show?: () => unknown; hide?: () => void }>;
    private readonly tabs = new Map<View, HTMLElement>();
    private readonly charts: ChartsView;
    private readonly player: PlayerView;
    private current: View | null = null;

    constructor(
        private readonly campaign: Campaign,
        runs: Runs,
        private readonly state: State,
        root: HTMLElement,
    ) {
        const theme = themeOf(state.get("theme", ""));
        this.charts = new ChartsView(campaign, runs, state, theme);
        this.player = new PlayerView(campaign, runs, state, theme);
        this.views = {
            overview: new Overview(campaign, runs),
            charts: this.charts,
            runs: new RunsView(campaign, runs, state),
            player: this.player,
        };
        const { title } = campaign.about;
        document.title = `${title} – MRPPSim`;
        root.append(el("header", {}, el("h1", {}, title), this.tabList(), this.themeChoice()));
        for (const [view, { element }] of Object.entries(this.views)) {
            element.id = `view-${view}`;
            element.setAttribute("role", "tabpanel");
            element.setAttribute("aria-labelledby", `tab-${view}`);
            element.hidden = true;
            root.append(element);
        }
        state.onChange((changed) => this.onState(changed));
        addEventListener("hashchange", () => state.reread());
        addEventListener("popstate", () => state.reread());
        onSystemTheme(() => this.applyTheme());
        addEventListener("beforeprint", () => this.applyTheme("light")); // paper is white
        addEventListener("afterprint", () => this.applyTheme());
        this.show();
    }

    private tabList(): HTMLElement {
        const list = el("div", { role: "tablist", "aria-label": "Views" });
        for (const view of Object.keys(kTitles) as View[]) {
            const tab = el(
                "button",
                { type: "button", role: "tab", id: `tab-${view}`, "aria-controls": `view-${view}` },
                kTitles[view],
            );
            tab.addEventListener("click", () => this.state.set({ view }, true));
            this.tabs.set(view, tab);
            list.append(tab);
        }
        list.addEventListener("keydown", (event) => {
            const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
            if (by === undefined) return;
            const order = [...this.tabs.keys()];
            const next = order[(order.indexOf(this.view) + by + order.length) % order.length];
            this.state.set({ view: next }, true);
            this.tabs.get(next)!.focus();
        });
        return list;
    }

    private themeChoice(): HTMLElement {
        const options: [string, string][] = [
            ["", "as the system"],
            ["light", "light"],
            ["dark", "dark"],
        ];
        return choice("Colours", options, this.state.get("theme", ""), (value) =>
            this.state.set({ theme: value === "" ? null : value }),
        );
    }

    private get view(): View {
        const usual = this.campaign.hasPlan ? "overview" : "player";
        const view = this.state.get("view", usual) as View;
        return view in kTitles ? view : usual;
    }

    private show(): void {
        const { view } = this;
        if (view !== this.current) {
            if (this.current) this.views[this.current].hide?.();
            this.current = view;
            for (const [name, { element }] of Object.entries(this.views)) element.hidden = name !== view;
            for (const [name, tab] of this.tabs) {
                tab.setAttribute("aria-selected", String(name === view));
                tab.tabIndex = name === view ? 0 : -1;
            }
        }
        void this.views[view].show?.();
    }

    private onState(changed: Set<string>): void {
        if (changed.has("theme")) this.applyTheme();
        this.show();
    }

    private applyTheme(choice = this.state.get("theme", "")): void {
        const theme = themeOf(choice);
        this.charts.setTheme(theme);
        this.player.setTheme(theme);
    }
}

async function begin(): Promise<void> {
    const root = document.getElementById("page")!;
    try {
        const campaign = Campaign.ofDocument();
        new Page(campaign, await campaign.runs(), new State(), root);
    } catch (error) {
        root.append(el("p", { role: "alert" }, `This page cannot be shown: ${String(error)}`));
        throw error;
    }
}

void begin();
