// What clicks and the key Home ask for.
#include "lab/view/input_handler.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <array>

namespace glint::view {
namespace input_handler_test {

class ClickTest : public testing::Test {
protected:
    void click(glm::vec2 at, double now) {
        state_.now = now;
        std::array<InputEvent, 3> events;
        events[0].kind = InputKind::Move;
        events[0].position = at;
        events[1].kind = events[2].kind = InputKind::Button;
        events[1].down = true;
        events[2].down = false;
        handler_.handle(events, state_, gui_, {640, 360}, 0.01);
    }
    void move(glm::vec2 to) {
        InputEvent event;
        event.kind = InputKind::Move;
        event.position = to;
        handler_.handle({&event, 1}, state_, gui_, {640, 360}, 0.01);
    }
    void key(int key) {
        InputEvent event;
        event.kind = InputKind::Key;
        event.key = key;
        event.down = true;
        handler_.handle({&event, 1}, state_, gui_, {640, 360}, 0.01);
    }
    bool turns() { return std::exchange(state_.focusAsked, false); }

    Gui gui_{1, {}};
    ViewerState state_{SettingsModel({}, {})};
    InputHandler handler_;
};

TEST_F(ClickTest, TwoOnOnePixelTurnToIt) {
    click({100, 100}, 10);
    EXPECT_FALSE(turns());
    click({102, 101}, 10.2); // a trembling hand
    EXPECT_TRUE(turns());
    click({102, 101}, 10.4);
    EXPECT_FALSE(turns()) << "the third is the first of the next two";
}

TEST_F(ClickTest, TwoOnDifferentPixelsAskTwice) {
    click({100, 100}, 10);
    click({160, 100}, 10.1);
    EXPECT_FALSE(turns());
    ASSERT_TRUE(state_.asked);
    EXPECT_NEAR(state_.asked->x, 0.25, 0.01);
    click({160, 100}, 10.3);
    EXPECT_TRUE(turns()) << "the second was the first of two on its pixel";
}

TEST_F(ClickTest, HomeAsksThePixelUnderTheMouseUntilItIsPressedAgain) {
    move({160, 90});
    EXPECT_FALSE(state_.asked);
    key(GLFW_KEY_HOME);
    ASSERT_TRUE(state_.asked);
    EXPECT_EQ(*state_.asked, glm::vec2(0.25f));
    move({320, 270});
    EXPECT_EQ(*state_.asked, glm::vec2(0.5f, 0.75f));
    key(GLFW_KEY_HOME);
    move({160, 90});
    EXPECT_EQ(*state_.asked, glm::vec2(0.5f, 0.75f));
    key(GLFW_KEY_HOME);
    click({480, 90}, 10);
    move({160, 90});
    EXPECT_EQ(*state_.asked, glm::vec2(0.75f, 0.25f)) << "a click chooses a pixel";
}

TEST_F(ClickTest, SlowOnesAreNoDoubleClick) {
    click({100, 100}, 0.1);
    EXPECT_FALSE(turns()) << "nothing was clicked before";
    click({100, 100}, 0.6);
    EXPECT_FALSE(turns());
}

} // namespace input_handler_test
} // namespace glint::view
